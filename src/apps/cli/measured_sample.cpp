#include "apps/cli/measured_sample.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

#include "apps/cli/brdf_source.h"
#include "apps/cli/measured_source.h"
#include "apps/cli/walk_sample.h"
#include "nacre/core/error.h"
#include "nacre/core/progress.h"
#include "nacre/io/measurement_file.h"
#include "nacre/io/recipe_file.h"
#include "nacre/measure/instrument.h"

namespace nacre::cli {

namespace {

/// Those readings of a file that were asked for.
void select(measure::Measurement& measurement, const std::vector<measure::Geometry>& geometries,
            const std::filesystem::path& path) {
    constexpr double kSame_deg = 0.1;
    std::vector<measure::Reading> selected;
    for (const measure::Geometry& wanted : geometries) {
        const auto found = std::find_if(
            measurement.readings.begin(), measurement.readings.end(), [&](const auto& reading) {
                return measure::separation_deg(reading.geometry, wanted) <= kSame_deg;
            });
        if (found == measurement.readings.end()) {
            throw InputError(fmt::format("{}: has no reading at {}", path.string(), wanted.name));
        }
        selected.push_back(*found);
    }
    measurement.readings = std::move(selected);
}

/// States colours under another light.
void recolour(measure::Measurement& measurement, const InstrumentRequest& request,
              const std::filesystem::path& path) {
    measure::Conditions conditions = measurement.conditions;
    conditions.illuminant = request.illuminant.value_or(conditions.illuminant);
    conditions.observer = request.observer.value_or(conditions.observer);
    if (request.aperture && *request.aperture != conditions.aperture) {
        throw InputError(fmt::format(
            "{}: was measured with half angles of {} and {} deg; --aperture cannot change that",
            path.string(), conditions.aperture.lamp_half_angle_deg,
            conditions.aperture.detector_half_angle_deg));
    }
    if (conditions == measurement.conditions) return;
    for (measure::Reading& reading : measurement.readings) {
        if (reading.reflectance_factor.empty()) {
            throw InputError(fmt::format(
                "{}: {} has no spectrum, so that it cannot be stated under another light",
                path.string(), reading.geometry.name));
        }
        reading = measure::coloured(reading.geometry, measurement.wavelengths_nm,
                                    reading.reflectance_factor, conditions);
    }
    measurement.conditions = conditions;
}

MeasuredSample read_sample(const std::filesystem::path& path, const InstrumentRequest& request) {
    // Spectra can be stated under another light, but not through other cones: an aperture that is
    // asked for stands for one that the file does not tell.
    measure::Conditions defaults;
    defaults.aperture = request.aperture.value_or(defaults.aperture);
    MeasuredSample sample{io::read_measurement(path, defaults), path.string(), "", ""};
    if (sample.measurement.name.empty()) sample.measurement.name = path.stem().string();
    if (request.wavelengths_nm) {
        throw InputError(
            fmt::format("{}: was measured at wavelengths of its own; --wavelength "
                        "cannot change them",
                        path.string()));
    }
    if (request.geometries) select(sample.measurement, *request.geometries, path);
    recolour(sample.measurement, request, path);
    return sample;
}

/// Beside a paint, a measured BRDF leaves the model to the paint, and --model is no mistake.
ModelOptions model_beside(const std::filesystem::path& other, const std::filesystem::path& path,
                          const ModelOptions& model) {
    return is_measured_brdf_file(path) && !is_measured_brdf_file(other) ? ModelOptions{} : model;
}

}  // namespace

bool is_measured_file(const std::filesystem::path& path) {
    // The beginning tells; solved paints and tables are large.
    std::ifstream file(path, std::ios::binary);
    std::string head(1 << 16, '\0');
    file.read(head.data(), static_cast<std::streamsize>(head.size()));
    head.resize(static_cast<std::size_t>(file.gcount()));
    return io::looks_like_measurement(head);
}

MeasuredSample measure_sample(const std::filesystem::path& path, const ModelOptions& model,
                              const InstrumentRequest& request, const CommonOptions& options) {
    const bool walks = parse_model(model).can.estimated_values;
    if (is_measured_file(path)) return read_sample(path, request);
    if (walks) {
        parse_model_settings(model, options.seed);  // refuses the options of other models
        return measure_by_walk(path, request, model.model, options);
    }
    const BrdfSource source =
        load_brdf(path, parse_brdf_request(model, options.seed), request.wavelengths_nm, options);
    const bool is_named = source.recipe && !source.recipe->name.empty();
    ProgressBar bar("measure", options.quiet);
    return {measure::measure(is_named ? source.recipe->name : path.stem().string(), source.brdf,
                             source.wavelengths_nm, request.geometries_or_default(),
                             request.conditions(), bar.callback()),
            path.string(),
            source.recipe ? io::recipe_hash(*source.recipe) : "",
            source.measured ? "" : model.model,
            {}};
}

std::pair<MeasuredSample, MeasuredSample> measure_both(const std::filesystem::path& sample,
                                                       const std::filesystem::path& standard,
                                                       const ModelOptions& model,
                                                       const InstrumentRequest& request,
                                                       const CommonOptions& options) {
    const bool sample_is_measured = is_measured_file(sample),
               standard_is_measured = is_measured_file(standard);
    if (sample_is_measured == standard_is_measured) {
        return {measure_sample(sample, model_beside(standard, sample, model), request, options),
                measure_sample(standard, model_beside(sample, standard, model), request, options)};
    }
    // The paint is read as the file was.
    const auto like = [](InstrumentRequest wanted, const measure::Measurement& file) {
        if (!wanted.geometries) {
            wanted.geometries.emplace();
            for (const measure::Reading& r : file.readings)
                wanted.geometries->push_back(r.geometry);
        }
        wanted.illuminant = file.conditions.illuminant;
        wanted.observer = file.conditions.observer;
        wanted.aperture = file.conditions.aperture;
        return wanted;
    };
    InstrumentRequest of_file = request;
    of_file.wavelengths_nm.reset();
    if (standard_is_measured) {
        MeasuredSample file = measure_sample(standard, model, of_file, options);
        return {measure_sample(sample, model, like(request, file.measurement), options),
                std::move(file)};
    }
    MeasuredSample file = measure_sample(sample, model, of_file, options);
    MeasuredSample paint =
        measure_sample(standard, model, like(request, file.measurement), options);
    return {std::move(file), std::move(paint)};
}

}  // namespace nacre::cli
