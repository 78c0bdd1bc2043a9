#include <nacre/nacre.h>

#include <cstdio>
#include <exception>
#include <numbers>

// The BRDF of a paint, lit from 45 degrees and seen from 30 on the mirror side.

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: brdf_value PAINT\n");
        return 1;
    }
    try {
        const nacre::Paint paint = nacre::open(argv[1]);
        const auto brdf = paint.brdf({.wavelengths_nm = {450, 550, 650}});
        constexpr double degree = std::numbers::pi / 180;
        const auto values = brdf(45 * degree, 30 * degree, 180 * degree);
        for (std::size_t i = 0; i < values.size(); ++i) {
            std::printf("%g nm: %.6g 1/sr\n", brdf.wavelengths_nm()[i], values[i]);
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "brdf_value: %s\n", error.what());
        return 2;
    }
}
