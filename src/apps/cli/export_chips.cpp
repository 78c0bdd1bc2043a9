#include "apps/cli/export_chips.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "apps/report/colour_chips.h"
#include "nacre/core/error.h"
#include "nacre/spectra/colour.h"

namespace nacre::cli {

namespace {

Vec3d linear_rgb(const Vec3d& lab) {
    return spectra::xyz_to_linear_rec709(
        spectra::lab_to_xyz(lab, spectra::linear_rec709_to_xyz({1, 1, 1})));
}

std::string display_colour(Vec3d rgb, double scale) {
    for (int c = 0; c < 3; ++c) {
        rgb[c] = spectra::srgb_encode(std::clamp(scale * rgb[c], 0.0, 1.0));
    }
    return spectra::css_colour(rgb);
}

report::ChipPair pair_of(const measure::AngleDifference& angle) {
    const Vec3d paint = linear_rgb(angle.lab_standard), fit = linear_rgb(angle.lab_sample);
    double brightest = 1;
    for (int c = 0; c < 3; ++c) brightest = std::max({brightest, paint[c], fit[c]});
    const std::string dimmed =
        brightest > 1.005 ? fmt::format(" (shown at 1/{:.1f})", brightest) : "";
    return {angle.geometry.name, display_colour(paint, 1 / brightest),
            display_colour(fit, 1 / brightest),
            fmt::format("\u0394E {:.1f}, L* {:.0f} and {:.0f}{}", angle.delta_e_2000,
                        angle.lab_standard[0], angle.lab_sample[0], dimmed)};
}

report::ChipGroup group_of(const std::string& title, const measure::Difference& difference,
                           std::size_t from = 0) {
    report::ChipGroup group{title, {}};
    for (std::size_t i = from; i < difference.angles.size(); ++i) {
        group.pairs.push_back(pair_of(difference.angles[i]));
    }
    return group;
}

}  // namespace

std::string material_chips(const std::string& paint, const FittedMaterial& material) {
    const exchange::MaterialFit& fit = material.fit;
    const auto line = [](const char* what, const measure::Difference& d) {
        return fmt::format("{}: mean \u0394E 2000 {:.1f}, greatest {:.1f}", what,
                           d.mean_delta_e_2000, d.max_delta_e_2000);
    };
    return report::chips_svg(
        fmt::format("{} as {}", paint, material.format),
        {"A fit of the format's own BRDF under D65, 2\u00b0, without the mirror image of the coat.",
         line("byk-mac's angles", fit.instrument), line("All angles of the fit", fit.fitted),
         line("Angles that the fit did not see", fit.tested)},
        "paint", "fit",
        {group_of("byk-mac's angles", fit.instrument),
         group_of("Other angles of the fit", fit.fitted, exchange::kBykMacAngles),
         group_of("Angles that the fit did not see", fit.tested)});
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
