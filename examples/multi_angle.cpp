#include <nacre/nacre.h>

#include <cstdio>
#include <exception>

// What a six-angle instrument reads on a paint, as CSV on standard output.

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: multi_angle PAINT\n");
        return 1;
    }
    try {
        const nacre::Paint paint = nacre::open(argv[1]);
        const auto readings =
            paint.measure(nacre::geometries("byk-mac"), {.illuminant = nacre::Illuminant::D65});
        std::fputs(readings.csv().c_str(), stdout);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "multi_angle: %s\n", error.what());
        return 2;
    }
}
