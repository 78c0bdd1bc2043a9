#include <fmt/format.h>
#include <nanobind/stl/array.h>
#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>
#include <nanobind/stl/vector.h>

#include <array>
#include <memory>
#include <optional>
#include <tuple>

#include "arrays.h"
#include "bind.h"
#include "nacre/core/file.h"
#include "nacre/core/math.h"
#include "nacre/io/recipe_file.h"
#include "nacre/models/models.h"
#include "nacre/nacre.h"
#include "nacre/solver/resolution.h"
#include "paint_handle.h"
#include "work.h"

namespace nacre::python {

namespace {

using namespace nb::literals;

using OptionalDoubles = std::optional<Doubles>;
using Patch = std::optional<std::tuple<double, double, double>>;

const char* name_of(Kind kind) {
    switch (kind) {
        case Kind::recipe:
            return "recipe";
        case Kind::solved_paint:
            return "solved_paint";
        case Kind::brdf_table:
            return "brdf_table";
        case Kind::measured_brdf:
            return "measured_brdf";
        case Kind::measured_colours:
            return "measured_colours";
    }
    return "";
}

BrdfSettings settings_of(const OptionalDoubles& wavelengths_nm, const std::optional<Model>& model,
                         const std::string& part, bool as_rendered) {
    BrdfSettings settings{.model = model, .part = part_of(part), .as_rendered = as_rendered};
    if (wavelengths_nm) settings.wavelengths_nm = to_vector(*wavelengths_nm);
    return settings;
}

std::shared_ptr<const PaintBrdf> brdf_of(const PaintHandle& handle, BrdfSettings settings,
                                         const Patch& patch, const nb::object& progress) {
    settings.patches = patch.has_value();
    // Those of all patches are made once, so that many may be asked for one by one.
    const auto on_patch = [&](const std::shared_ptr<const PaintBrdf>& brdf) {
        if (!patch) return brdf;
        const auto& [x, y, side] = *patch;
        return std::make_shared<const PaintBrdf>(brdf->on(x, y, side));
    };
    for (const auto& known : handle.brdfs) {
        if (known.model == settings.model && known.part == settings.part &&
            known.as_rendered == settings.as_rendered && known.patches == settings.patches &&
            known.wavelengths_nm == settings.wavelengths_nm) {
            return on_patch(known.brdf);
        }
    }
    auto brdf = run(progress, [&](const Progress& callback) {
        return std::make_shared<const PaintBrdf>(handle.paint.brdf(settings, callback));
    });
    constexpr std::size_t kKept = 8;
    if (handle.brdfs.size() == kKept) handle.brdfs.erase(handle.brdfs.begin());
    handle.brdfs.push_back({settings.wavelengths_nm, settings.model, settings.part,
                            settings.as_rendered, settings.patches, brdf});
    return on_patch(brdf);
}

/// Squares and products between these are neither rounded to nothing nor infinite. Beyond them angles
/// are found by what takes three times as long.
constexpr Range kSafeSquares{1e-280, 1e280};

/// The polar angle of a direction, which need not be of length 1.
double polar_angle(const double* w) {
    const double square = w[0] * w[0] + w[1] * w[1];
    const bool safe = kSafeSquares.contains(square);
    return std::atan2(safe ? std::sqrt(square) : std::hypot(w[0], w[1]), w[2]);
}

/// phi_o - phi_i; 0 where one of them is the normal, which has no azimuth.
double azimuth_between(const double* wi, const double* wo) {
    const double across = wi[0] * wo[1] - wi[1] * wo[0], along = wi[0] * wo[0] + wi[1] * wo[1];
    if (kSafeSquares.contains(std::abs(across) + std::abs(along))) return std::atan2(across, along);
    const auto is_normal = [](const double* w) { return w[0] == 0 && w[1] == 0; };
    if (is_normal(wi) || is_normal(wo)) return 0;
    return std::atan2(wo[1], wo[0]) - std::atan2(wi[1], wi[0]);
}

/// Of a paint whose flakes lean, from the lamp's azimuth: phi_o, if phi_i is 0.
double azimuth_from_lean(const double* wi, const double* wo) {
    if (wi[1] != 0 || wi[0] < 0) {
        throw DomainError(
            "wi: must have the azimuth 0 (y = 0, x >= 0), as flakes that lean do so from the "
            "lamp's; turn the paint by lean.azimuth_deg");
    }
    return std::atan2(wo[1], wo[0]);
}

void require_direction(const char* name, const double* w) {
    const bool finite = std::isfinite(w[0]) && std::isfinite(w[1]) && std::isfinite(w[2]);
    if (!finite || (w[0] == 0 && w[1] == 0 && w[2] == 0)) {
        throw DomainError(std::string(name) + ": a direction must be finite and have a length");
    }
}

bool asks_for_none(const OptionalDoubles& wavelengths_nm) {
    return wavelengths_nm && wavelengths_nm->size() == 0;
}

/// The values at no wavelengths.
template <std::size_t N>
NumpyArray<double> none_of(const Broadcast<N>& places) {
    return to_numpy(std::vector<double>(), places.shape_with(0));
}

NumpyArray<double> brdf_by_directions(const PaintHandle& handle, const Doubles& wi,
                                      const Doubles& wo, const OptionalDoubles& wavelengths_nm,
                                      const std::optional<Model>& model, const std::string& part,
                                      bool as_rendered, const Patch& patch,
                                      const nb::object& progress) {
    const Broadcast<2> places({&wi, &wo}, {"wi", "wo"}, 3);
    if (asks_for_none(wavelengths_nm)) return none_of(places);
    const auto brdf =
        brdf_of(handle, settings_of(wavelengths_nm, model, part, as_rendered), patch, progress);
    const std::size_t width = brdf->wavelengths_nm().size();
    const bool leans = handle.paint.has_recipe() && handle.paint.recipe().flake_lean().has_value();
    Unwritten<double> values(places.size_with(width));
    for_each(places.size(), [&](std::size_t place) {
        const double *i = places.at(0, place), *o = places.at(1, place);
        require_direction("wi", i);
        require_direction("wo", o);
        double* const to = values.at(place * width);
        if (i[2] <= 0 || o[2] <= 0) {  // below the horizon: opaque
            std::fill_n(to, width, 0.0);
            return;
        }
        const std::vector<double> f =
            (*brdf)(polar_angle(i), polar_angle(o),
                    leans ? azimuth_from_lean(i, o) : azimuth_between(i, o));
        std::copy(f.begin(), f.end(), to);
    });
    return std::move(values).to_numpy(places.shape_with(width));
}

NumpyArray<double> brdf_by_angles(const PaintHandle& handle, const Doubles& theta_i_deg,
                                  const Doubles& theta_o_deg, const Doubles& phi_deg,
                                  const OptionalDoubles& wavelengths_nm,
                                  const std::optional<Model>& model, const std::string& part,
                                  bool as_rendered, const Patch& patch,
                                  const nb::object& progress) {
    const Broadcast<3> places({&theta_i_deg, &theta_o_deg, &phi_deg},
                              {"theta_i_deg", "theta_o_deg", "phi_deg"}, 1);
    // Each array by itself: of a million and a million there are 1e12 places.
    const auto check = [](const Doubles& degrees, const char* name, const auto& require) {
        for_each(degrees.size(), [&](std::size_t i) { require(name, degrees.data()[i]); });
    };
    check(theta_i_deg, "theta_i_deg", require_polar_angle);
    check(theta_o_deg, "theta_o_deg", require_polar_angle);
    check(phi_deg, "phi_deg", require_finite_angle);
    if (asks_for_none(wavelengths_nm)) return none_of(places);
    const auto brdf =
        brdf_of(handle, settings_of(wavelengths_nm, model, part, as_rendered), patch, progress);
    const std::size_t width = brdf->wavelengths_nm().size();
    Unwritten<double> values(places.size_with(width));
    for_each(places.size(), [&](std::size_t place) {
        const std::vector<double> f =
            (*brdf)(*places.at(0, place) * kDegree, *places.at(1, place) * kDegree,
                    *places.at(2, place) * kDegree);
        std::copy(f.begin(), f.end(), values.at(place * width));
    });
    return std::move(values).to_numpy(places.shape_with(width));
}

using Parameter = std::tuple<std::string, double, double, double, std::string>;

std::vector<Parameter> parameters(const PaintHandle& handle) {
    std::vector<Parameter> all;
    for (const paint::RecipeParameter& p : paint::recipe_parameters(handle.paint.recipe())) {
        all.emplace_back(p.key, p.value, p.range.lo, p.range.hi, p.range.unit);
    }
    return all;
}

double value_of(const PaintHandle& handle, const std::string& key) {
    return paint::find_parameter(handle.paint.recipe(), handle.paint.whole_key(key)).value;
}

nb::dict solve(const PaintHandle& handle, const OptionalDoubles& wavelengths_nm, int exit_nodes,
               int inner_nodes, int max_orders, double tolerance, const nb::object& progress) {
    SolveSettings settings;
    if (wavelengths_nm) settings.wavelengths_nm = to_vector(*wavelengths_nm);
    settings.resolution = {exit_nodes, inner_nodes, max_orders, tolerance};
    solver::check(settings.resolution);  // else they would be said to be of the file
    const auto solved = run(progress, [&](const Progress& callback) {
        return handle.paint.solved(settings, callback);
    });
    nb::dict result;
    result["wavelengths_nm"] = to_numpy(std::vector<double>(solved->wavelengths_nm()));
    result["exit_nodes"] = solved->report.exit_nodes;
    result["inner_nodes"] = solved->report.inner_nodes;
    result["orders"] = solved->report.orders;
    result["unresolved_scattering"] = solved->report.unresolved_scattering;
    result["azimuthal_tail"] = solved->report.azimuthal_tail;
    return result;
}

std::vector<std::string> warnings(const PaintHandle& handle) {
    std::vector<std::string> texts;
    for (const SolverWarning& warning : handle.paint.warnings()) texts.push_back(warning.message);
    return texts;
}

using Error2 = std::pair<double, double>;

Error2 write(const Exported& exported, const std::filesystem::path& path) {
    exported.write(path);
    return {exported.error.flux, exported.error.peak};
}

BrdfSettings export_settings(const OptionalDoubles& wavelengths_nm,
                             const std::optional<Model>& model) {
    return settings_of(wavelengths_nm, model, "total", true);
}

Error2 write_rgl(const PaintHandle& handle, const std::filesystem::path& path, int resolution,
                 int incidences, bool rgb, const OptionalDoubles& wavelengths_nm,
                 const std::optional<Model>& model, const nb::object& progress) {
    const RglSettings rgl{.resolution = resolution, .incident = incidences, .rgb = rgb};
    return run(progress, [&](const Progress& callback) {
        return write(handle.paint.export_rgl(rgl, export_settings(wavelengths_nm, model), callback),
                     path);
    });
}

Error2 write_merl(const PaintHandle& handle, const std::filesystem::path& path,
                  const std::tuple<int, int, int>& cells, const OptionalDoubles& wavelengths_nm,
                  const std::optional<Model>& model, const nb::object& progress) {
    const auto& [half, difference, azimuths] = cells;
    return run(progress, [&](const Progress& callback) {
        return write(handle.paint.export_merl({half, difference, azimuths},
                                              export_settings(wavelengths_nm, model), callback),
                     path);
    });
}

/// A geometry, Delta E 2000, and CIELAB of the paint and of the material.
using Angle = std::tuple<std::string, double, std::array<double, 3>, std::array<double, 3>>;
/// Of all geometries, and mean and greatest Delta E 2000.
using Differences = std::tuple<std::vector<Angle>, double, double>;

Differences differences(const measure::Difference& difference) {
    const auto numbers = [](const Vec3d& lab) { return std::array{lab[0], lab[1], lab[2]}; };
    std::vector<Angle> angles;
    for (const measure::AngleDifference& angle : difference.angles) {
        angles.emplace_back(angle.geometry.name, angle.delta_e_2000, numbers(angle.lab_standard),
                            numbers(angle.lab_sample));
    }
    return {angles, difference.mean_delta_e_2000, difference.max_delta_e_2000};
}

using Fitted =
    std::tuple<std::vector<std::pair<std::string, double>>, Differences, Differences, Differences>;

Fitted write_material(const PaintHandle& handle, const std::filesystem::path& path,
                      const std::string& format, const OptionalDoubles& wavelengths_nm,
                      const std::optional<Model>& model, const nb::object& progress) {
    return run(progress, [&](const Progress& callback) {
        const FittedMaterial made =
            handle.paint.export_material(format == "gltf"        ? MaterialFormat::gltf
                                         : format == "materialx" ? MaterialFormat::materialx
                                                                 : MaterialFormat::cycles,
                                         export_settings(wavelengths_nm, model), callback);
        made.write(path);
        return Fitted{made.parameters, differences(made.fit.instrument),
                      differences(made.fit.fitted), differences(made.fit.tested)};
    });
}

Differences write_shader(const PaintHandle& handle, const std::filesystem::path& path,
                         const std::optional<Model>& model, const nb::object& progress) {
    return run(progress, [&](const Progress& callback) {
        const ShaderMaterial made = handle.paint.export_threejs(model, callback);
        made.write(path);
        return differences(made.difference);
    });
}

/// The solution, or the table that the model makes of it.
std::size_t write_solved(const PaintHandle& handle, const std::filesystem::path& path,
                         const OptionalDoubles& wavelengths_nm, const std::optional<Model>& model,
                         const nb::object& progress) {
    SolveSettings settings;
    if (wavelengths_nm) settings.wavelengths_nm = to_vector(*wavelengths_nm);
    return run(progress, [&](const Progress& callback) {
        const std::string bytes = model && model->makes_table()
                                      ? handle.paint.export_table(*model, settings, callback)
                                      : handle.paint.export_solved(settings, callback);
        write_file_atomically(path, bytes, callback);
        return bytes.size();
    });
}

PaintHandle from_bytes(const nb::bytes& bytes, const std::filesystem::path& name,
                       const std::optional<std::filesystem::path>& folder,
                       const std::filesystem::path& sample) {
    std::string contents(bytes.c_str(), bytes.size());
    const nb::gil_scoped_release release;
    return {open_text(std::move(contents), name.string(),
                      folder ? References::anywhere(*folder) : References(), sample.string())};
}

std::vector<std::string> model_names() {
    std::vector<std::string> names;
    for (const bsdf::ModelInfo* model : models::all_models()) names.emplace_back(model->name);
    return names;
}

}  // namespace

Part part_of(const std::string& name) {
    if (name == "total") return Part::total;
    if (name == "single") return Part::single;
    if (name == "multiple") return Part::multiple;
    throw SettingError("part", "must be total, single or multiple", name);
}

void require_polar_angle(const char* name, double deg) {
    if (!kPolarAngleRange.contains(deg)) {
        throw SettingError(name, "must be in " + kPolarAngleRange.text(), fmt::format("{}", deg));
    }
}

void require_finite_angle(const char* name, double deg) {
    if (!std::isfinite(deg)) throw SettingError(name, "must be finite", fmt::format("{}", deg));
}

void bind_paint(nb::module_& module) {
    // For plans of libraries, which are checked before anything is computed.
    const auto bounds = [](const Range& range) {
        return nb::make_tuple(static_cast<int>(range.lo), static_cast<int>(range.hi));
    };
    module.attr("RGL_RESOLUTION_RANGE") = bounds(RglSettings::kResolutionRange);
    module.attr("RGL_INCIDENT_RANGE") = bounds(RglSettings::kIncidentRange);
    nb::class_<bsdf::Model>(module, "Model")
        .def(nb::new_(&configured_model), "name"_a, "options"_a)
        .def("text", &bsdf::Model::text)
        .def("shows_flakes", [](const bsdf::Model& model) { return model.info().can.sparkle; });
    module.def("model_names", &model_names);
    module.def("default_picture_model",
               [] { return std::string(models::default_picture_model().info().name); });
    module.def("models_with_arrays", [] {
        const auto names = models::names_with_arrays();
        return std::vector<std::string>(names.begin(), names.end());
    });
    module.def("model_switches", &model_switches, "name"_a);
    module.def("shipped_paints", &shipped_paints);

    const auto wavelengths = nb::arg("wavelengths_nm").none();
    const auto model = nb::arg("model").none();
    nb::class_<PaintHandle>(module, "Paint")
        .def_static(
            "open",
            [](const std::filesystem::path& path) {
                return PaintHandle{nacre::open(find_paint(path.string()))};
            },
            "path"_a, nb::call_guard<nb::gil_scoped_release>())
        .def_static("from_bytes", &from_bytes, "data"_a, "name"_a, "folder"_a.none(),
                    "sample"_a = "")
        .def_prop_ro("kind", [](const PaintHandle& p) { return name_of(p.paint.kind()); })
        .def_prop_ro("file", [](const PaintHandle& p) { return path_text(p.paint.file()); })
        .def_prop_ro("name", [](const PaintHandle& p) { return name_text(p.paint.name()); })
        .def_prop_ro("sha256", [](const PaintHandle& p) { return p.paint.recipe_sha256(); })
        .def("toml",
             [](const PaintHandle& p) {
                 return io::write_recipe(p.paint.recipe(), p.paint.bounds(), p.paint.deviations(),
                                         p.paint.correlations());
             })
        .def("contents",
             [](const PaintHandle& p) {
                 const PaintContents contents = p.paint.contents();
                 return nb::make_tuple(nb::bytes(contents.bytes.data(), contents.bytes.size()),
                                       path_text(p.paint.file()), path_text(contents.sample));
             })
        .def("parameters", &parameters)
        .def(
            "whole_key",
            [](const PaintHandle& p, const std::string& key) { return p.paint.whole_key(key); },
            "key"_a)
        .def("value", &value_of, "key"_a)
        .def(
            "with_value",
            [](const PaintHandle& p, const std::string& key, double value) {
                return PaintHandle{p.paint.with(key, value)};
            },
            "key"_a, "value"_a)
        .def(
            "free_keys",
            [](const PaintHandle& p, const std::vector<std::string>& patterns) {
                return p.paint.free_keys(patterns).keys;
            },
            "patterns"_a)
        .def("solve", &solve, wavelengths, "exit_nodes"_a, "inner_nodes"_a, "max_orders"_a,
             "tolerance"_a, "progress"_a.none())
        .def("warnings", &warnings)
        .def("implausible_numbers",
             [](const PaintHandle& p) { return p.paint.implausible_numbers(); })
        .def("notes", [](const PaintHandle& p) { return p.paint.notes(); })
        .def(
            "wavelengths_nm",
            [](const PaintHandle& p, const std::optional<Model>& chosen) {
                const auto brdf =
                    brdf_of(p, settings_of({}, chosen, "total", false), {}, nb::none());
                return to_numpy(std::vector<double>(brdf->wavelengths_nm()));
            },
            model)
        .def("brdf", &brdf_by_directions, "wi"_a, "wo"_a, wavelengths, model, "part"_a,
             "as_rendered"_a, "patch"_a.none(), "progress"_a.none())
        .def("brdf_at", &brdf_by_angles, "theta_i_deg"_a, "theta_o_deg"_a, "phi_deg"_a, wavelengths,
             model, "part"_a, "as_rendered"_a, "patch"_a.none(), "progress"_a.none())
        .def("write_rgl", &write_rgl, "path"_a, "resolution"_a, "incidences"_a, "rgb"_a,
             wavelengths, model, "progress"_a.none())
        .def("write_material", &write_material, "path"_a, "format"_a, wavelengths, model,
             "progress"_a.none())
        .def("write_shader", &write_shader, "path"_a, model, "progress"_a.none())
        .def("write_merl", &write_merl, "path"_a, "cells"_a, wavelengths, model,
             "progress"_a.none())
        .def("write_solved", &write_solved, "path"_a, wavelengths, model, "progress"_a.none());
}

}  // namespace nacre::python
