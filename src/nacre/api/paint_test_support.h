#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "nacre/core/file.h"
#include "nacre/io/recipe_file.h"
#include "nacre/io/solved_paint_file.h"
#include "nacre/nacre.h"
#include "nacre/testing/files.h"
#include "nacre/testing/fit.h"

// Only for tests: paints of every kind.

namespace nacre::test {

/// Flakes of so wide an orientation that they are solved in an instant.
inline std::string pearl_toml() { return io::write_recipe(fit::testing::pearl()); }
inline const SolveSettings kThree{{450, 550, 650}};

/// One file of each kind, or two.
struct Sample {
    std::string name;
    Kind kind;
    std::string bytes;
};
inline const std::vector<Sample>& samples() {
    static const std::vector<Sample> all = [] {
        std::vector<Sample> samples = {
            {"pearl.toml", Kind::recipe, pearl_toml()},
            {"pearl.h5", Kind::solved_paint,
             io::solved_paint_bytes(*Paint(fit::testing::pearl()).solved(kThree))}};
        const std::vector<std::pair<std::string, Kind>> files = {
            {"brdf_table/raw.h5", Kind::brdf_table},
            {"brdf_table/svd.h5", Kind::brdf_table},
            {"rgl/isotropic_spectral.bsdf", Kind::measured_brdf},
            {"merl/small.binary", Kind::measured_brdf},
            {"measurement/pearl.csv", Kind::measured_colours},
            {"measurement/pearl.json", Kind::measured_colours}};
        for (const auto& [name, kind] : files) {
            samples.push_back({std::filesystem::path(name).filename().string(), kind,
                               read_file(shipped_file("fuzz/corpus/" + name))});
        }
        return samples;
    }();
    return all;
}

}  // namespace nacre::test
