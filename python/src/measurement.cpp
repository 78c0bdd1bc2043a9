#include <nanobind/stl/array.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <array>
#include <limits>
#include <nlohmann/json.hpp>
#include <tuple>

#include "arrays.h"
#include "bind.h"
#include "nacre/core/file.h"
#include "nacre/io/measurement_file.h"
#include "nacre/measure/difference.h"
#include "nacre/nacre.h"
#include "paint_handle.h"
#include "readings_handle.h"
#include "work.h"

namespace nacre::python {

namespace {

using namespace nb::literals;
using OptionalDoubles = std::optional<Doubles>;
using OptionalText = std::optional<std::string>;
using measure::Reading;

/// One number of each reading.
template <class Get>
NumpyArray<double> each(const Readings& readings, const Get& get) {
    std::vector<double> values;
    for (const Reading& reading : readings.measurement.readings) values.push_back(get(reading));
    return to_numpy(std::move(values));
}

/// Three numbers of each reading.
template <class Get>
NumpyArray<double> each_triple(const Readings& readings, const Get& get) {
    std::vector<double> values;
    for (const Reading& reading : readings.measurement.readings) {
        const Vec3d triple = get(reading);
        for (int c = 0; c < 3; ++c) values.push_back(triple[c]);
    }
    return to_numpy(std::move(values), {readings.measurement.readings.size(), 3});
}

/// By reading and wavelength; NaN where a reading has no spectrum.
NumpyArray<double> reflectance(const Readings& readings) {
    const std::size_t width = readings.measurement.wavelengths_nm.size();
    std::vector<double> values;
    for (const Reading& reading : readings.measurement.readings) {
        std::vector<double> row = reading.reflectance_factor;
        row.resize(width, std::numeric_limits<double>::quiet_NaN());
        values.insert(values.end(), row.begin(), row.end());
    }
    return to_numpy(std::move(values), {readings.measurement.readings.size(), width});
}

std::optional<NumpyArray<double>> standard_error(const Readings& readings) {
    if (readings.standard_error.empty()) return std::nullopt;
    std::vector<double> values;
    for (const auto& row : readings.standard_error) {
        values.insert(values.end(), row.begin(), row.end());
    }
    return to_numpy(std::move(values),
                    {readings.standard_error.size(), readings.standard_error.at(0).size()});
}

std::vector<std::string> names(const Readings& readings) {
    std::vector<std::string> all;
    for (const Reading& r : readings.measurement.readings) all.push_back(r.geometry.name);
    return all;
}

std::string json(const Readings& readings) {
    return io::measurement_json(readings.measurement)
               .dump(2, ' ', false, nlohmann::json::error_handler_t::replace) +
           "\n";
}

MeasureSettings settings_of(const std::optional<Model>& model, const OptionalText& illuminant_name,
                            const OptionalText& observer_name,
                            const std::optional<std::pair<double, double>>& aperture_deg,
                            const OptionalDoubles& wavelengths_nm, std::uint64_t walks,
                            std::uint64_t seed) {
    MeasureSettings settings{.model = model, .walks = walks, .seed = seed};
    if (illuminant_name) settings.illuminant = illuminant(*illuminant_name);
    if (observer_name) settings.observer = observer(*observer_name);
    if (aperture_deg) settings.aperture = {aperture_deg->first, aperture_deg->second};
    if (wavelengths_nm) settings.wavelengths_nm = to_vector(*wavelengths_nm);
    return settings;
}

Readings from_spectra(const std::string& name, const std::string& geometry,
                      const Doubles& wavelengths_nm, const Doubles& reflectance_factor,
                      const std::string& illuminant_name, const std::string& observer_name) {
    Readings readings;
    const std::vector<Geometry> set = geometries(geometry);
    const std::vector<double> nm = to_vector(wavelengths_nm);
    if (reflectance_factor.ndim() != 2 || reflectance_factor.shape(0) != set.size() ||
        reflectance_factor.shape(1) != nm.size()) {
        throw DomainError("R: must have the shape " + text_of({set.size(), nm.size()}) +
                          ", by geometry and wavelength");
    }
    readings.measurement.name = name;
    readings.measurement.conditions = {illuminant(illuminant_name), observer(observer_name), {}};
    readings.measurement.wavelengths_nm = nm;
    for (std::size_t g = 0; g < set.size(); ++g) {
        const double* row = reflectance_factor.data() + g * nm.size();
        readings.measurement.readings.push_back(
            measure::coloured(set[g], nm, {row, row + nm.size()}, readings.measurement.conditions));
    }
    return readings;
}

using GeometryState = std::tuple<std::string, double, double, double, double>;
using ReadingState =
    std::tuple<GeometryState, std::vector<double>, std::array<double, 3>, std::array<double, 3>>;
using ReadingsState = std::tuple<nb::bytes, int, int, double, double, std::vector<double>,
                                 std::vector<ReadingState>, std::vector<std::vector<double>>>;

/// For pickling: every number, bit for bit.
ReadingsState state_of(const Readings& readings) {
    const measure::Measurement& m = readings.measurement;
    std::vector<ReadingState> all;
    for (const Reading& r : m.readings) {
        const Geometry& g = r.geometry;
        all.emplace_back(
            GeometryState(g.name, g.theta_i_deg, g.aspecular_deg, g.theta_o_deg, g.phi_deg),
            r.reflectance_factor, std::array{r.xyz[0], r.xyz[1], r.xyz[2]},
            std::array{r.lab[0], r.lab[1], r.lab[2]});
    }
    return {nb::bytes(m.name.data(), m.name.size()),
            static_cast<int>(m.conditions.illuminant),
            static_cast<int>(m.conditions.observer),
            m.conditions.aperture.lamp_half_angle_deg,
            m.conditions.aperture.detector_half_angle_deg,
            m.wavelengths_nm,
            all,
            readings.standard_error};
}

Readings from_state(const ReadingsState& state) {
    const auto& [name, illuminant, observer, lamp, detector, nm, all, standard_error] = state;
    Readings readings;
    readings.measurement = {std::string(name.c_str(), name.size()),
                            {static_cast<spectra::Illuminant>(illuminant),
                             static_cast<spectra::Observer>(observer),
                             {lamp, detector}},
                            nm,
                            {}};
    readings.standard_error = standard_error;
    for (const auto& [geometry, factor, xyz, lab] : all) {
        const auto& [text, theta_i, aspecular, theta_o, phi] = geometry;
        readings.measurement.readings.push_back({{text, theta_i, aspecular, theta_o, phi},
                                                 factor,
                                                 {xyz[0], xyz[1], xyz[2]},
                                                 {lab[0], lab[1], lab[2]}});
    }
    return readings;
}

std::optional<double> travel(const Readings& readings) {
    const measure::ColourTravel travelled = measure::colour_travel(readings.measurement);
    if (travelled.path.size() < 2) return std::nullopt;
    return travelled.length;
}

/// A standard deviation that has none is NaN.
double number_or_nan(const std::optional<double>& value) {
    return value.value_or(std::numeric_limits<double>::quiet_NaN());
}

nb::object metric_of(const std::optional<fit::MetricUncertainty>& metric) {
    if (!metric) return nb::none();
    return nb::make_tuple(metric->value, metric->best());
}

nb::list numbers_of(const Uncertainty& uncertainty) {
    nb::list all;
    for (const fit::UncertainNumber& number : uncertainty.numbers) {
        all.append(nb::make_tuple(number.key, number.value, number.standard_deviation,
                                  number.meets_range));
    }
    return all;
}

nb::dict uncertainty_of(const Uncertainty& uncertainty) {
    const std::size_t n = uncertainty.readings.size(), k = uncertainty.numbers.size();
    std::vector<double> lab, covariance, chroma, hue, change, shares, factor;
    std::vector<std::vector<std::string>> fails;
    for (const fit::ReadingUncertainty& reading : uncertainty.readings) {
        const fit::Spread& spread = reading.best();
        const Vec3d sd = spread.lab();
        lab.insert(lab.end(), {sd[0], sd[1], sd[2]});
        for (const Vec3d& row : spread.covariance) {
            covariance.insert(covariance.end(), {row[0], row[1], row[2]});
        }
        chroma.push_back(number_or_nan(spread.chroma));
        hue.push_back(number_or_nan(spread.hue_deg));
        for (const Vec3d& by : reading.change) change.insert(change.end(), {by[0], by[1], by[2]});
        const std::vector<double> share =
            fit::variance_fractions(reading.change, uncertainty.correlation);
        shares.insert(shares.end(), share.begin(), share.end());
        factor.insert(factor.end(), spread.reflectance_factor.begin(),
                      spread.reflectance_factor.end());
        std::vector<std::string>& names = fails.emplace_back();
        for (const fit::Quantity quantity : reading.doubtful()) {
            names.emplace_back(fit::name_of(quantity));
        }
    }
    const std::size_t width = n > 0 ? factor.size() / n : 0;
    nb::dict result;
    result["measurement"] = Readings{uncertainty.measurement};
    result["numbers"] = numbers_of(uncertainty);
    std::vector<double> correlation;
    for (std::size_t i = 0; i < k; ++i) {
        const std::vector<double> row = uncertainty.correlation_of(i);
        correlation.insert(correlation.end(), row.begin(), row.end());
    }
    result["correlation"] = to_numpy(std::move(correlation), Shape{k, k});
    result["Lab_sd"] = to_numpy(std::move(lab), Shape{n, 3});
    result["Lab_covariance"] = to_numpy(std::move(covariance), Shape{n, 3, 3});
    result["C_sd"] = to_numpy(std::move(chroma));
    result["h_sd"] = to_numpy(std::move(hue));
    result["R_sd"] = to_numpy(std::move(factor), Shape{n, width});
    result["change"] = to_numpy(std::move(change), Shape{n, k, 3});
    result["shares"] = to_numpy(std::move(shares), Shape{n, k});
    result["first_order_fails"] = fails;
    result["flop_index"] = metric_of(uncertainty.flop_index);
    result["colour_travel"] = metric_of(uncertainty.colour_travel);
    result["samples"] = uncertainty.samples;
    return result;
}

}  // namespace

nb::dict difference_of(const measure::Difference& difference) {
    std::vector<std::string> names;
    std::vector<double> standard, sample, delta, chroma, hue, de, weight;
    for (const measure::AngleDifference& angle : difference.angles) {
        names.push_back(angle.geometry.name);
        for (int c = 0; c < 3; ++c) {
            standard.push_back(angle.lab_standard[c]);
            sample.push_back(angle.lab_sample[c]);
            delta.push_back(angle.delta_lab[c]);
        }
        chroma.push_back(angle.delta_chroma());
        hue.push_back(angle.delta_hue());
        de.push_back(angle.delta_e_2000);
        weight.push_back(angle.weight);
    }
    const Shape triples = {names.size(), 3};
    nb::dict result;
    result["geometries"] = nb::cast(names);
    result["Lab_standard"] = to_numpy(std::move(standard), triples);
    result["Lab_sample"] = to_numpy(std::move(sample), triples);
    result["dLab"] = to_numpy(std::move(delta), triples);
    result["dC"] = to_numpy(std::move(chroma));
    result["dH"] = to_numpy(std::move(hue));
    result["dE2000"] = to_numpy(std::move(de));
    result["weights"] = to_numpy(std::move(weight));
    result["mean_dE2000"] = difference.mean_delta_e_2000;
    result["max_dE2000"] = difference.max_delta_e_2000;
    result["illuminant"] = spectra::name(difference.conditions.illuminant);
    result["observer"] = spectra::name(difference.conditions.observer);
    return result;
}

void bind_measurement(nb::module_& module) {
    const auto geometry_number = [](double Geometry::*member) {
        return [member](const Readings& r) {
            return each(r, [&](const Reading& reading) { return reading.geometry.*member; });
        };
    };
    nb::class_<Readings>(module, "Readings")
        .def_static("from_spectra", &from_spectra, "name"_a, "geometry"_a, "wavelengths_nm"_a,
                    "R"_a, "illuminant"_a, "observer"_a)
        .def_prop_ro("name", [](const Readings& r) { return name_text(r.measurement.name); })
        .def_prop_ro("geometries", &names)
        .def_prop_ro("theta_i_deg", geometry_number(&Geometry::theta_i_deg), kOwned)
        .def_prop_ro("theta_o_deg", geometry_number(&Geometry::theta_o_deg), kOwned)
        .def_prop_ro("phi_deg", geometry_number(&Geometry::phi_deg), kOwned)
        .def_prop_ro("aspecular_deg", geometry_number(&Geometry::aspecular_deg), kOwned)
        .def_prop_ro(
            "wavelengths_nm",
            [](const Readings& r) {
                return to_numpy(std::vector<double>(r.measurement.wavelengths_nm));
            },
            kOwned)
        .def_prop_ro("R", &reflectance, kOwned)
        .def_prop_ro("standard_error", &standard_error, kOwned)
        .def_prop_ro(
            "XYZ",
            [](const Readings& r) {
                return each_triple(r, [](const Reading& one) { return one.xyz; });
            },
            kOwned)
        .def_prop_ro(
            "Lab",
            [](const Readings& r) {
                return each_triple(r, [](const Reading& one) { return one.lab; });
            },
            kOwned)
        .def_prop_ro(
            "C",
            [](const Readings& r) {
                return each(r, [](const Reading& one) { return measure::chroma(one.lab); });
            },
            kOwned)
        .def_prop_ro(
            "h",
            [](const Readings& r) {
                return each(r, [](const Reading& one) { return measure::hue_deg(one.lab); });
            },
            kOwned)
        .def_prop_ro(
            "illuminant",
            [](const Readings& r) { return spectra::name(r.measurement.conditions.illuminant); })
        .def_prop_ro(
            "observer",
            [](const Readings& r) { return spectra::name(r.measurement.conditions.observer); })
        .def_prop_ro("aperture_deg",
                     [](const Readings& r) {
                         const Aperture& aperture = r.measurement.conditions.aperture;
                         return std::pair(aperture.lamp_half_angle_deg,
                                          aperture.detector_half_angle_deg);
                     })
        .def_prop_ro("flop_index",
                     [](const Readings& r) { return measure::flop_index(r.measurement); })
        .def_prop_ro("colour_travel", &travel)
        .def("__getstate__", &state_of, kGetStateSignature)
        .def(
            "__setstate__",
            [](Readings& readings, const ReadingsState& state) {
                new (&readings) Readings(from_state(state));
            },
            kSetStateSignature)
        .def("csv", &Readings::csv)
        .def("json", &json);
    module.def(
        "measure",
        [](const PaintHandle& handle, const std::string& geometry,
           const std::optional<Model>& model, const OptionalText& illuminant_name,
           const OptionalText& observer_name,
           const std::optional<std::pair<double, double>>& aperture_deg,
           const OptionalDoubles& wavelengths_nm, std::uint64_t walks, std::uint64_t seed,
           const nb::object& progress) {
            const MeasureSettings settings = settings_of(model, illuminant_name, observer_name,
                                                         aperture_deg, wavelengths_nm, walks, seed);
            return run(progress, [&](const Progress& callback) {
                return handle.paint.measure(
                    geometry.empty() ? std::vector<Geometry>() : geometries(geometry), settings,
                    callback);
            });
        },
        "paint"_a, "geometry"_a, "model"_a.none(), "illuminant"_a.none(), "observer"_a.none(),
        "aperture_deg"_a.none(), "wavelengths_nm"_a.none(), "walks"_a, "seed"_a,
        "progress"_a.none());
    module.def(
        "uncertainty",
        [](const PaintHandle& handle, const std::string& geometry,
           const std::optional<Model>& model, const OptionalText& illuminant_name,
           const OptionalText& observer_name, const OptionalDoubles& wavelengths_nm,
           const std::map<std::string, std::string>& deviations,
           const std::vector<std::pair<std::vector<std::string>, double>>& correlations,
           int samples, std::uint64_t seed, const nb::object& progress) {
            const MeasureSettings settings = settings_of(model, illuminant_name, observer_name,
                                                         std::nullopt, wavelengths_nm, 1 << 18, 0);
            UncertaintySettings uncertain{.samples = samples, .seed = seed};
            for (const auto& [key, text] : deviations) {
                uncertain.deviations.push_back(paint::parse_deviation(key, text));
            }
            for (const auto& [keys, coefficient] : correlations) {
                uncertain.correlations.push_back({keys, coefficient});
            }
            return uncertainty_of(run(progress, [&](const Progress& callback) {
                return handle.paint.measure_uncertainty(
                    geometry.empty() ? std::vector<Geometry>() : geometries(geometry), settings,
                    uncertain, callback);
            }));
        },
        "paint"_a, "geometry"_a, "model"_a.none(), "illuminant"_a.none(), "observer"_a.none(),
        "wavelengths_nm"_a.none(), "deviations"_a, "correlations"_a, "samples"_a, "seed"_a,
        "progress"_a.none());
    module.def(
        "difference",
        [](const Readings& standard, const Readings& sample,
           const std::map<std::string, double>& weights) {
            return difference_of(
                measure::difference(standard.measurement, sample.measurement, weights));
        },
        "standard"_a, "sample"_a, "weights"_a);
    module.def(
        "write_text",
        [](const std::filesystem::path& path, const std::string& text) {
            write_file_atomically(path, text);
        },
        "path"_a, "text"_a);
    module.def("geometry_sets", [] {
        std::map<std::string, std::string> sets;
        for (const measure::GeometrySet& set : measure::geometry_sets()) {
            sets.emplace(set.name, set.summary);
        }
        return sets;
    });
}

}  // namespace nacre::python
