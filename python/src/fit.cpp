#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include "arrays.h"
#include "bind.h"
#include "nacre/fit/fitted_uncertainty.h"
#include "nacre/library.h"
#include "nacre/nacre.h"
#include "paint_handle.h"
#include "readings_handle.h"
#include "work.h"

namespace nacre::python {

namespace {

using namespace nb::literals;

nb::list parameters_of(const Match& match) {
    nb::list all;
    for (const fit::FittedParameter& p : match.parameters) {
        nb::dict one;
        one["key"] = p.number.bounds.key;
        one["value"] = p.value;
        one["standard_error"] = p.standard_error;
        one["start"] = p.number.start;
        one["lo"] = p.number.bounds.lo;
        one["hi"] = p.number.bounds.hi;
        one["at_bound"] = p.at_lower_bound || p.at_upper_bound;
        all.append(one);
    }
    return all;
}

nb::list tradeoffs_of(const Match& match) {
    nb::list all;
    for (const fit::Tradeoff& tradeoff : match.tradeoffs) {
        nb::dict changes;
        for (const auto& change : tradeoff.changes) {
            changes[change.key.c_str()] = nb::make_tuple(change.from, change.to);
        }
        nb::dict one;
        one["changes"] = changes;
        one["rms_dE"] = tradeoff.rms_delta_e;
        all.append(one);
    }
    return all;
}

nb::list alternatives_of(const Match& match) {
    nb::list all;
    for (const fit::Minimum& minimum : match.alternatives) {
        nb::dict values;
        for (std::size_t i = 0; i < minimum.values.size(); ++i) {
            values[match.parameters[i].number.bounds.key.c_str()] = minimum.values[i];
        }
        nb::dict one;
        one["values"] = values;
        one["mean_dE2000"] = minimum.mean_delta_e_2000;
        one["max_dE2000"] = minimum.max_delta_e_2000;
        all.append(one);
    }
    return all;
}

nb::list remedies_of(const Match& match) {
    nb::list all;
    for (const fit::Remedy& remedy : match.remedies) {
        nb::dict one;
        one["key"] = remedy.key;
        one["widens"] = remedy.widens;
        one["lo"] = remedy.bounds.lo;
        one["hi"] = remedy.bounds.hi;
        one["value"] = remedy.value;
        one["mean_dE2000"] = remedy.mean_delta_e_2000;
        all.append(one);
    }
    return all;
}

nb::dict other_lights_of(const Match& match) {
    nb::dict all;
    for (const auto& [light, difference] : match.other_lights) {
        all[spectra::name(light).c_str()] = difference_of(difference);
    }
    return all;
}

nb::dict match_of(const Match& match) {
    nb::dict result;
    result["paint"] = PaintHandle{match.paint};
    const fit::FittedUncertainty known = fit::fitted_uncertainty(match);
    result["uncertain_paint"] =
        PaintHandle{match.paint.with_uncertainty(known.deviations, known.correlations)};
    result["parameters"] = parameters_of(match);
    result["standard"] = Readings{match.standard};
    result["colours"] = Readings{match.colours};
    result["difference"] = difference_of(match.difference);
    result["at_start"] = difference_of(match.at_start);
    result["other_lights"] = other_lights_of(match);
    nb::dict skipped;
    for (const fit::SkippedNumber& one : match.skipped) skipped[one.key.c_str()] = one.why;
    result["skipped"] = skipped;
    result["matched"] = match.matched();
    result["remedies"] = remedies_of(match);
    result["converged"] = match.converged;
    result["ended"] = match.ended;
    result["tradeoffs"] = tradeoffs_of(match);
    result["alternatives"] = alternatives_of(match);
    result["solves"] = match.effort.solves;
    result["seconds"] = match.effort.seconds;
    return result;
}

}  // namespace

void bind_fit(nb::module_& module) {
    nb::class_<FitSettings>(module, "FitSettings")
        .def(
            "__init__",
            [](FitSettings* place, const Readings& standard, const std::optional<Model>& model,
               const std::vector<std::string>& also, const std::map<std::string, double>& weights,
               int starts, std::uint64_t seed, const std::optional<double>& noise_dE,
               double equal_dE, double matched_dE) {
                FitSettings settings;
                settings.starts = starts;
                settings.seed = seed;
                settings.noise_delta_e = noise_dE;
                settings.equal_delta_e = equal_dE;
                settings.matched_delta_e = matched_dE;
                settings.target.weights = weights;
                settings.target.hot_spot = model && shows_hot_spot(*model);
                if (!also.empty()) {
                    settings.target.illuminants = {standard.measurement.conditions.illuminant};
                    for (const std::string& name : also) {
                        settings.target.illuminants.push_back(illuminant(name));
                    }
                }
                new (place) FitSettings(std::move(settings));
            },
            "standard"_a, "model"_a.none(), "also"_a, "weights"_a, "starts"_a, "seed"_a,
            "noise_dE"_a.none(), "equal_dE"_a, "matched_dE"_a);
    module.def(
        "fit",
        [](const Readings& standard, const PaintHandle& start, const std::vector<std::string>& free,
           const FitSettings& settings, const nb::object& progress) {
            return match_of(run(progress, [&](const Progress& callback) {
                return start.paint.fit(standard.measurement, free, settings, callback);
            }));
        },
        "standard"_a, "start"_a, "free"_a, "settings"_a, "progress"_a.none());
    module.def(
        "fit_from_library",
        [](const Readings& standard, const std::filesystem::path& library,
           std::size_t constructions, const FitSettings& settings, const nb::object& progress) {
            const std::vector<ConstructionMatch> matches =
                run(progress, [&](const Progress& callback) {
                    return fit_from_library(library, standard.measurement, constructions, settings,
                                            callback);
                });
            nb::list all;
            for (const ConstructionMatch& m : matches) {
                nb::dict one;
                one["construction"] = m.start.construction;
                one["record"] = path_text(m.start.folder.string());
                one["name"] = m.start.name;
                one["nearest_mean_dE2000"] = m.start.mean_delta_e_2000;
                one["match"] = match_of(m.match);
                all.append(one);
            }
            return all;
        },
        "standard"_a, "library"_a, "constructions"_a, "settings"_a, "progress"_a.none());
}

}  // namespace nacre::python
