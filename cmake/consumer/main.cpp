#include <cmath>
#include <cstdio>

#include "nacre/io/recipe_file.h"
#include "nacre/optics/thin_film.h"
#include "nacre/solver/solver.h"

// Uses one thing from the bottom and one from the top of Nacre, from an installed copy: a film
// whose reflectance is known, and a recipe file that is read and solved.

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: consumer RECIPE\n");
        return 1;
    }
    // A quarter wave of index 1.38 on glass.            [macleod-2010, section 4.1]
    const double wavelength_nm = 550;
    const nacre::optics::ThinFilm film{1.38, wavelength_nm / (4 * 1.38)};
    const auto rt = nacre::optics::stack_reflectance(1.0, {&film, 1}, 1.52, 1.0, wavelength_nm,
                                                     nacre::optics::Polarization::unpolarized);
    if (std::abs(rt.reflectance - .012600790215) > 1e-12) {
        std::fprintf(stderr, "consumer: R = %.15g\n", rt.reflectance);
        return 1;
    }

    const auto recipe = nacre::io::read_recipe(argv[1]);
    const auto paint = nacre::solver::solve(recipe, {wavelength_nm});
    std::printf("R = %.12g; solved '%s'\n", rt.reflectance, recipe.name.c_str());
    return 0;
}
