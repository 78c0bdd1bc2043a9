#include <nacre/nacre.h>

#include <cstdio>
#include <exception>
#include <variant>

// Finds the thickness of the outer film again: the paint is measured, its film made thinner by a
// tenth, and fitted to what was measured.

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: fit PAINT\n");
        return 1;
    }
    try {
        const char* const key = "layer[0].flakes[0].coats[0].thickness_nm";
        const nacre::Paint standard = nacre::open(argv[1]);
        const auto readings = standard.measure(nacre::geometries("byk-mac"));
        const double truth =
            std::get<nacre::optics::Platelet>(standard.recipe().layers[0].flakes[0].body)
                .coats[0]
                .thickness_nm;
        const auto match = standard.with(key, 0.9 * truth).fit(readings.measurement, {key});
        for (const auto& found : match.parameters) {
            std::printf("%s: %.3f (of the standard: %.3f)\n", found.number.bounds.key.c_str(),
                        found.value, truth);
        }
    } catch (const std::exception& error) {
        std::fprintf(stderr, "fit: %s\n", error.what());
        return 2;
    }
}
