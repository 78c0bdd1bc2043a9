#include "apps/cli/export_chips.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>

#include "apps/report/colour_chips.h"
#include "nacre/core/error.h"

namespace nacre::cli {

namespace {

report::ChipPair pair_of(const measure::AngleDifference& angle) {
    const measure::DisplayPair shown = measure::display_pair(angle);
    const std::string dimmed =
        shown.dimmed > 1.005 ? fmt::format(" (shown at 1/{:.1f})", shown.dimmed) : "";
    return {angle.geometry.name, shown.standard, shown.sample,
            fmt::format("\u0394E {:.1f}, L* {:.0f} and {:.0f}{}", angle.delta_e_2000,
                        angle.lab_standard[0], angle.lab_sample[0], dimmed)};
}

report::ChipGroup group_of(const std::string& title, const measure::Difference& difference,
                           std::size_t from = 0, std::size_t to = SIZE_MAX) {
    report::ChipGroup group{title, {}};
    for (std::size_t i = from; i < std::min(to, difference.angles.size()); ++i) {
        group.pairs.push_back(pair_of(difference.angles[i]));
    }
    return group;
}

constexpr const char* kBykMac = "byk-mac's angles";

std::string line(const char* what, const measure::Difference& d) {
    return fmt::format("{}: mean \u0394E 2000 {:.1f}, greatest {:.1f}", what, d.mean_delta_e_2000,
                       d.max_delta_e_2000);
}

}  // namespace

std::string material_chips(const std::string& paint, const FittedMaterial& material) {
    const exchange::MaterialFit& fit = material.fit;
    return report::chips_svg(
        fmt::format("{} as {}", paint, material.format),
        {"A fit of the format's own BRDF under D65, 2\u00b0, without the mirror image of the coat.",
         line("byk-mac's angles", fit.instrument), line("All angles of the fit", fit.fitted),
         line("Angles that the fit did not see", fit.tested)},
        "paint", "fit",
        {group_of(kBykMac, fit.instrument),
         group_of("Other angles of the fit", fit.fitted, exchange::kBykMacAngles),
         group_of("Angles that the fit did not see", fit.tested)});
}

std::string shader_chips(const std::string& paint, const ShaderMaterial& material) {
    const measure::Difference& all = material.difference;
    return report::chips_svg(
        fmt::format("{} in three.js", paint),
        {"The shader's BRDF under D65, 2\u00b0, without the mirror image of the coat.",
         line("All angles", all)},
        "paint", "shader",
        {group_of(kBykMac, all, 0, exchange::kBykMacAngles),
         group_of("Other angles", all, exchange::kBykMacAngles)});
}

void check_chips_beside(const std::string& file) {
    std::error_code none;
    if (!std::filesystem::is_regular_file(file, none)) return;
    const std::string mark = report::kChipsMark;
    std::ifstream in(file, std::ios::binary);
    std::string begin(mark.size(), '\0');
    in.read(begin.data(), static_cast<std::streamsize>(begin.size()));
    if (in && begin == mark) return;
    throw InputError(fmt::format(
        "{}: is no picture of Nacre's; rename or remove it, or name another by --chips", file));
}

}  // namespace nacre::cli
