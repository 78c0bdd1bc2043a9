#include "apps/study/sparkle_series.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "nacre/bsdf/models/nacre.h"
#include "nacre/core/file.h"
#include "nacre/io/recipe_file.h"
#include "nacre/solver/solver.h"

namespace nacre::study {
namespace {

// The camera's own, so that nothing is interpolated between wavelengths.
std::vector<double> camera_wavelengths_nm() {
    std::vector<double> wavelengths;
    for (int nm = 400; nm <= 700; nm += 20) wavelengths.push_back(nm);
    return wavelengths;
}

}  // namespace

paint::Recipe silver_with(FlakeParameter parameter, double value) {
    constexpr double kLarge_um = 30, kDarkPrimer = 0.01;
    paint::Recipe recipe = io::read_recipe(shipped_file("paints/metallic-silver.toml"));
    paint::FlakeSpecies& flake = recipe.layers[0].flakes[0];
    switch (parameter) {
        case FlakeParameter::diameter:
            flake.diameter_um = value;
            flake.diameter_spread_um = value / 3;
            break;
        case FlakeParameter::volume:
            flake.amount = paint::VolumeFraction{value};
            flake.diameter_um = kLarge_um;
            flake.diameter_spread_um = kLarge_um / 3;
            recipe.substrate_reflectance = spectra::Spectrum(kDarkPrimer);
            break;
        case FlakeParameter::orientation:
            flake.orientation.beckmann_alpha = value;
            break;
    }
    return recipe;
}

measure::SparkleCamera camera_for(const paint::Recipe& recipe, double field_mm) {
    measure::SparkleCamera camera;
    camera.field_mm = field_mm;
    // Large flakes are few, and reflect into the camera rarely.
    constexpr double kLarge_um = 28, kWider = 2.4, kLargePixel_um = 40;
    if (recipe.layers[0].flakes[0].diameter_um > kLarge_um) {
        camera.field_mm *= kWider;
        camera.pixel_um = kLargePixel_um;
    }
    return camera;
}

PanelLook look_at(const paint::Recipe& recipe, const measure::SparkleCamera& camera,
                  std::uint64_t seed, const Progress& progress) {
    const bsdf::Model model = bsdf::NacreModel{.specimen = seed};
    const auto solved = std::make_shared<const solver::SolvedPaint>(
        solver::solve(recipe, camera_wavelengths_nm(), {}, nullptr, progress));
    const auto surface = model.make({recipe, solved}, progress);
    PanelLook look;
    look.pictures = measure::take_pictures(*surface, camera, progress);
    look.readings = measure::measure_pictures(camera, look.pictures, {}, progress);
    return look;
}

std::string name(SparkleMeasure measure) {
    switch (measure) {
        case SparkleMeasure::density:
            return "spots per cm²";
        case SparkleMeasure::intensity:
            return "log10 of intensity";
        case SparkleMeasure::sparkle:
            return "sparkle";
        case SparkleMeasure::graininess:
            return "graininess";
    }
    return "";
}

Estimate reading(const measure::SparkleMeasurement& readings, SparkleMeasure measure,
                 std::size_t lamp) {
    constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
    const Estimate none{kNone, kNone};
    if (measure == SparkleMeasure::graininess) {
        return readings.diffuse ? readings.diffuse->graininess : none;
    }
    const measure::Sparkle& s = readings.by_lamp.at(lamp);
    if (measure == SparkleMeasure::density) return s.density_per_cm2;
    if (measure == SparkleMeasure::sparkle) return s.sparkle_per_cm2;
    if (!s.intensity) return none;
    // The logarithm, of which intensity is the mean.
    const double value = s.intensity->value;
    return {std::log10(value), s.intensity->standard_error / value / std::numbers::ln10};
}

TrendVerdict judge(const std::vector<Estimate>& readings, Trend trend) {
    std::vector<Estimate> known;
    std::copy_if(readings.begin(), readings.end(), std::back_inserter(known), [](const auto& r) {
        return std::isfinite(r.value) && std::isfinite(r.standard_error);
    });
    if (known.size() < 2) return {};
    const auto in_errors = [&](const Estimate& a, const Estimate& b) {
        const double change = trend == Trend::rises ? b.value - a.value : a.value - b.value;
        const double error = std::hypot(a.standard_error, b.standard_error);
        return error > 0 ? change / error : 0;
    };
    TrendVerdict verdict{known.front(), known.back(), in_errors(known.front(), known.back()), 0};
    for (std::size_t i = 1; i < known.size(); ++i) {
        verdict.worst_step_in_errors =
            std::min(verdict.worst_step_in_errors, in_errors(known[i - 1], known[i]));
    }
    return verdict;
}

}  // namespace nacre::study
