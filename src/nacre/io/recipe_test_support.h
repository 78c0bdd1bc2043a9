#pragma once

#include <string>

#include "nacre/io/recipe_file.h"
#include "nacre/testing/errors.h"

// Recipes to test their reader with.

namespace nacre::io::recipes {

// The recipe of docs/recipe.md, every table once.
inline const std::string kViolet = R"(name = "Violet pearl"
ior = 1.5

[clearcoat]
thickness_um = 45
absorption_per_mm = { wavelengths_nm = [400, 700], values = [0.2, 0.0] }
roughness = 0.0

[[layer]]
thickness_um = 15

[[layer.flakes]]
name = "TiO2 on mica"
volume_fraction = 0.03
diameter_um = 18
diameter_spread_um = 6
orientation = { distribution = "beckmann", alpha = 0.1 }
core  = { material = "mica", thickness_nm = 500, spread_nm = 60 }
coats = [ { material = "TiO2_anatase", thickness_nm = 80, spread_nm = 5, distribution = "uniform" } ]

[[layer.pigment]]
scattering_per_mm = 200.0
absorption_per_mm = 50.0
anisotropy = 0.2

[substrate]
reflectance = 0.05
)";

inline const std::string kBounded = kViolet + R"([fit]
"layer[0].flakes[0].coats[0].thickness_nm" = [60, 140]
"layer[0].thickness_um" = [10, 20.5]
)";

inline const std::string kUncertain = kViolet + R"([uncertainty]
"layer[0].flakes[0].coats[0].thickness_nm" = 1.5
"layer[0].thickness_um" = "7 %"
)";

inline const std::string kCorrelated = kUncertain + R"("clearcoat.thickness_um" = 2

[[uncertainty.correlation]]
of = ["layer[0].thickness_um", "clearcoat.thickness_um"]
coefficient = 0.8

[[uncertainty.correlation]]
of = ["layer[0].thickness_um", "layer[0].flakes[0].coats[0].thickness_nm"]
coefficient = -0.25
)";

inline const std::string kGray = R"(ior = 1.5
[[layer]]
thickness_um = 15
[[layer.flakes]]
area_density_per_um = 0.1
orientation = { distribution = "beckmann", alpha = 0.1 }
reflectance = 0.6
transmittance = 0.3
thickness_um = 0.3
)";

inline const std::string kMicrofacet = R"(ior = 1.5
[microfacet]
alpha = 0.07
film_ior = 1.8
film_thickness_nm = 158.333
base_ior = 1.08
base_extinction = 0.51
[microfacet.facets]
count = 10_000_000
cone_deg = 3.0
thickness_spread_nm = 10.0
)";

inline paint::Recipe parse(const std::string& text) { return parse_recipe(text, "paint.toml", ""); }

inline std::string refused_recipe(const std::string& text) {
    return nacre::test::message_of<InputError>([&] { parse(text); });
}

}  // namespace nacre::io::recipes
