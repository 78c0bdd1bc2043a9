#include <fmt/format.h>

#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "nacre/core/version.h"
#include "nacre/exchange/cycles_material.h"

namespace nacre::exchange {

extern const char* const kCyclesNodes;

namespace {

std::string python_color(const Vec3d& c) {
    return fmt::format("({:.6g}, {:.6g}, {:.6g})", c.x, c.y, c.z);
}

/// "45as15 2.3, ..." in lines of comment.
std::string by_angle(const measure::Difference& difference) {
    std::string text;
    for (std::size_t i = 0; i < difference.angles.size(); ++i) {
        const measure::AngleDifference& angle = difference.angles[i];
        text += fmt::format("{}{} {:.1f}", i % 6 == 0 ? "\n#   " : ", ", angle.geometry.name,
                            angle.delta_e_2000);
    }
    return text + '\n';
}

std::string mean_and_greatest(const measure::Difference& difference) {
    return fmt::format("{:.1f}, {:.1f}", difference.mean_delta_e_2000, difference.max_delta_e_2000);
}

std::string paint_literal(const CyclesMaterial& m, const std::string& name, double flake_um) {
    // JSON's escapes are Python's too.
    std::string text = fmt::format("PAINT = {{\n    \"name\": {},\n    \"flake_size\": {:.6g},\n",
                                   nlohmann::json(name).dump(), 1e-6 * flake_um);
    text += fmt::format("    \"diffuse\": {},\n    \"lobes\": [\n", python_color(m.diffuse));
    for (const CyclesLobe& lobe : m.lobes) {
        text += fmt::format(
            "        {{\n            \"roughness\": {:.6g},\n"
            "            \"widening\": {:.6g},\n            \"lean\": {:.6g},\n"
            "            \"color\": [\n",
            lobe.roughness, lobe.widening, lobe.lean);
        for (const Vec3d& stop : lobe.color.stops) {
            text += fmt::format("                {},\n", python_color(stop));
        }
        text += "            ],\n        },\n";
    }
    text += "    ],\n";
    if (m.coat) {
        text += fmt::format("    \"coat\": {{\"ior\": {:.6g}, \"roughness\": {:.6g}}},\n",
                            m.coat_ior, m.coat_roughness);
    }
    return text + "}\n";
}

}  // namespace

std::string cycles_text(const CyclesMaterial& material, const std::string& name,
                        const MaterialFit& fit, double flake_um) {
    return fmt::format(
        "\"\"\"A paint for Blender's Cycles: a node group and a material of it, by Nacre {}.\n\n"
        "Run it in Blender's text editor or by `blender --python`: the active object gets the "
        "material.\n"
        "Another script gets it by `runpy.run_path(file)[\"build_material\"]()`.\n\"\"\"\n\n"
        "# A fit, not the paint. CIEDE2000 from the paint, mean and greatest: {} at byk-mac's "
        "angles:{}"
        "# {} at all angles of the fit\n# {} at angles that the fit did not see:{}\n"
        "import math\n\nimport bpy\n\n{}\n{}",
        version(), mean_and_greatest(fit.instrument), by_angle(fit.instrument),
        mean_and_greatest(fit.fitted), mean_and_greatest(fit.tested), by_angle(fit.tested),
        paint_literal(material, name, flake_um), kCyclesNodes);
}

}  // namespace nacre::exchange
