#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <string>
#include <string_view>
#include <vector>

#include "arrays.h"
#include "bind.h"
#include "nacre/models/models.h"
#include "nacre/nacre.h"
#include "paint_handle.h"
#include "work.h"

namespace nacre::python {

namespace {

using namespace nb::literals;

/// @throws SettingError
void require_sparkle(const Model& model) {
    const bsdf::ModelInfo& info = model.info();
    if (info.can.sparkle && !info.can.reference_only) return;
    std::vector<std::string_view> others;
    for (const bsdf::ModelInfo* known : models::all_models()) {
        if (known->can.sparkle && !known->can.reference_only) others.push_back(known->name);
    }
    throw SettingError("model",
                       fmt::format("{}, so that there is no sparkle to be measured; must be {}",
                                   info.can.reference_only ? "follows light and has no values"
                                                           : "shows no single flakes",
                                   fmt::join(others, " or ")),
                       std::string(info.name));
}

nb::object pair_of(const std::optional<Estimate>& estimate, double scale = 1) {
    if (!estimate) return nb::none();
    return nb::make_tuple(scale * estimate->value, scale * estimate->standard_error);
}

nb::object picture_of(measure::PanelPicture picture) {
    const Shape shape = {static_cast<std::size_t>(picture.height),
                         static_cast<std::size_t>(picture.width), 3};
    return nb::cast(to_numpy(std::move(picture.xyz), shape));
}

nb::list lamps_of(SparkleReadings& readings) {
    nb::list lamps;
    for (std::size_t i = 0; i < readings.measurement.by_lamp.size(); ++i) {
        const measure::Sparkle& s = readings.measurement.by_lamp[i];
        nb::dict lamp;
        lamp["lamp_deg"] = readings.measurement.lamps_deg[i];
        lamp["Y"] = 100 * s.mean_y;
        lamp["background_Y"] = 100 * s.background.y;
        lamp["threshold_Y"] = 100 * s.background.threshold;
        lamp["eye_blur_um"] = 1e3 * s.blur_mm;
        lamp["area_mm2"] = s.area_mm2;
        lamp["spots_per_cm2"] = pair_of(s.density_per_cm2);
        lamp["intensity"] = pair_of(s.intensity);
        lamp["contrast"] = pair_of(s.contrast);
        lamp["area_percent"] = pair_of(s.area_fraction, 100);
        lamp["sparkle"] = pair_of(s.sparkle_per_cm2);
        lamp["pixel_contrast"] = pair_of(s.pixel_contrast);
        lamp["picture"] = picture_of(std::move(readings.pictures.by_lamp[i]));
        lamps.append(lamp);
    }
    return lamps;
}

}  // namespace

void bind_sparkle(nb::module_& module) {
    using measure::SparkleCamera;
    // For plans of libraries, as those of RGL tables.
    module.attr("SPARKLE_MAX_LAMPS") = static_cast<int>(SparkleCamera::kMaxLamps);
    module.attr("SPARKLE_LAMP_RANGE_DEG") =
        nb::make_tuple(SparkleCamera::kLampRange.lo, SparkleCamera::kLampRange.hi);
    module.def(
        "sparkle",
        [](const PaintHandle& handle, const Model& model, const std::vector<double>& lamps_deg,
           double lamp_half_angle_deg, double field_mm, double pixel_um, int diffuse_samples,
           double panel_mm, double distance_mm, double illuminance_lx, std::uint64_t seed,
           const nb::object& progress) {
            require_sparkle(model);
            SparkleSettings settings;
            settings.camera = {.pixel_um = pixel_um,
                               .field_mm = field_mm,
                               .lamps_deg = lamps_deg,
                               .lamp_half_angle_deg = lamp_half_angle_deg,
                               .diffuse_samples = diffuse_samples,
                               .seed = seed,
                               .unit_square_mm = panel_mm};
            settings.viewing = {distance_mm, illuminance_lx};
            SparkleReadings readings = run(progress, [&](const Progress& callback) {
                measure::check(settings.camera);  // before the paint is solved
                measure::check(settings.viewing);
                // A bar is for the pictures; solving only asks.
                const Progress only_asks = [&](double) { return callback(0); };
                return measure_sparkle(*handle.paint.appearance(model, {}, only_asks), settings,
                                       callback);
            });
            nb::dict result;
            result["flakes_resolved"] = readings.pictures.flakes_resolved;
            result["lamps"] = lamps_of(readings);
            result["diffuse"] = nb::none();
            if (const auto& diffuse = readings.measurement.diffuse) {
                nb::dict d;
                d["Y"] = 100 * diffuse->mean_y;
                d["graininess"] = pair_of(diffuse->graininess);
                d["pixel_contrast"] = pair_of(diffuse->pixel_contrast);
                result["diffuse"] = d;
            }
            return result;
        },
        "paint"_a, "model"_a, "lamps_deg"_a, "lamp_half_angle_deg"_a, "field_mm"_a, "pixel_um"_a,
        "diffuse_samples"_a, "panel_mm"_a, "distance_mm"_a, "illuminance_lx"_a, "seed"_a,
        "progress"_a.none());
}

}  // namespace nacre::python
