#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <utility>

#include "arrays.h"
#include "bind.h"
#include "nacre/bsdf/models/nacre_arrays.h"
#include "nacre/exchange/webgl_shader.h"
#include "nacre/nacre.h"
#include "paint_handle.h"
#include "work.h"

// The models microflake and nacre as arrays, for nacre.mitsuba, and as a shader of WebGL 2.

namespace nacre::python {

namespace {

using namespace nb::literals;
using bsdf::NacreArrays;

template <class T>
NumpyArray<T> array(std::vector<T> values, const Shape& shape) {
    if (values.size() != count(shape)) throw Error("internal: an array of another size");
    return to_numpy(std::move(values), shape);
}

nb::dict layer_arrays(NacreArrays::Layer&& layer, std::size_t directions, std::size_t w) {
    nb::list flakes, pigments;
    for (NacreArrays::Flake& flake : layer.flakes) {
        nb::dict d;
        d["area_density_per_um"] = flake.area_density_per_um;
        d["alpha"] = flake.alpha;
        d["reflectance"] =
            array(std::move(flake.reflectance), {static_cast<std::size_t>(flake.cosines), w});
        flakes.append(d);
    }
    for (NacreArrays::Pigment& pigment : layer.pigments) {
        nb::dict d;
        d["anisotropy"] = pigment.anisotropy;
        d["scattering_per_um"] = array(std::move(pigment.scattering_per_um), {w});
        const std::size_t angles = pigment.phase.size() / w;
        d["phase"] = array(std::move(pigment.phase), {angles, w});
        pigments.append(d);
    }
    nb::dict d;
    d["thickness_um"] = layer.thickness_um;
    d["extinction_per_um"] = array(std::move(layer.extinction_per_um), {directions, w});
    d["flakes"] = flakes;
    d["pigments"] = pigments;
    return d;
}

template <class Numbers>
nb::list list_of(const Numbers& numbers) {
    nb::list list;
    for (const auto& x : numbers) list.append(x);
    return list;
}

nb::dict species_arrays(NacreArrays::Species&& species, std::size_t w) {
    const auto& field = species.field;
    nb::dict d;
    d["cell_mm"] = list_of(field.cell_mm);
    d["key"] = list_of(field.key);
    d["fraction"] = list_of(field.fraction);
    d["cumulative"] = list_of(field.cumulative);
    d["full_cells"] = list_of(field.full_cells);
    d["inverse_cover"] = field.inverse_cover;
    d["typical_radius"] = field.typical_radius;
    d["max_widening"] = field.max_widening;
    d["density_per_mm2"] = species.density_per_mm2;
    d["alpha"] = species.alpha;
    d["waviness"] = species.waviness;
    d["radius_um"] = species.radius_um;
    d["diameter_um"] = to_numpy(std::move(species.diameter_um));
    d["film_min_cosine"] = species.film_min_cosine;
    constexpr std::size_t kCosines = bsdf::FlakeFilms::kCosineIntervals + 1;
    d["film_ratio"] = array(std::move(species.film_ratio),
                            {static_cast<std::size_t>(species.film_sets), kCosines, w});
    return d;
}

nb::dict to_dict(NacreArrays&& a) {
    using sparkle::DiffractionLobe;
    const std::size_t w = a.wavelengths_nm.size(), directions = bsdf::kDirectionIntervals + 1;
    const auto rank = static_cast<std::size_t>(a.rank);
    const auto by_direction = [&](auto&& values) {
        const Shape shape = {values.empty() ? 0 : directions, w};
        return array(std::forward<decltype(values)>(values), shape);
    };
    nb::dict d;
    d["wavelengths_nm"] = to_numpy(std::move(a.wavelengths_nm));
    d["ior"] = to_numpy(std::move(a.ior));
    d["clearcoat_depth"] = to_numpy(std::move(a.clearcoat_depth));
    d["mean_ior"] = a.mean_ior;
    d["coat_roughness"] = a.coat_roughness;
    d["smooth"] = array(std::move(a.smooth),
                        {static_cast<std::size_t>(a.grid.a), static_cast<std::size_t>(a.grid.b),
                         static_cast<std::size_t>(a.grid.q), rank});
    d["smooth_basis"] = array(std::move(a.smooth_basis), {rank, w});
    d["single_rank"] = a.single_rank;
    nb::list layers;
    for (NacreArrays::Layer& layer : a.layers) {
        layers.append(layer_arrays(std::move(layer), directions, w));
    }
    d["layers"] = layers;
    const std::size_t sampled = a.probability.empty() ? 0 : directions;
    d["probability"] = array(std::move(a.probability), {sampled, 4});
    d["albedo"] = by_direction(std::move(a.albedo));
    d["masking_over_cosine"] = to_numpy(std::move(a.masking_over_cosine));
    d["masked"] = by_direction(std::move(a.masked));
    d["diffuse_scale"] = to_numpy(std::move(a.diffuse_scale));
    if (a.hot_spot) {
        nb::list species;
        for (NacreArrays::HotSpotSpecies& s : a.hot_spot->species) {
            nb::dict one;
            one["layer"] = s.layer;
            one["diameter_um"] = s.diameter_um;
            one["coupling"] = by_direction(std::move(s.coupling));
            species.append(one);
        }
        nb::dict hot_spot;
        hot_spot["species"] = species;
        hot_spot["ground"] = by_direction(std::move(a.hot_spot->ground));
        hot_spot["compensation"] = by_direction(std::move(a.hot_spot->compensation));
        d["hot_spot"] = hot_spot;
    } else {
        d["hot_spot"] = nb::none();
    }
    nb::list species;
    for (NacreArrays::Species& s : a.species) species.append(species_arrays(std::move(s), w));
    d["species"] = species;
    const auto table = [](std::span<const float> values) {
        return array(std::vector<float>(values.begin(), values.end()),
                     {DiffractionLobe::kWidthNodes, DiffractionLobe::kSquareNodes});
    };
    d["log_blur"] = table(DiffractionLobe::log_blur_table());
    d["inverse_lobe_fraction"] = table(DiffractionLobe::inverse_lobe_fraction_table());
    return d;
}

NacreArrays arrays_of(const PaintHandle& handle, const Model& model, bsdf::ArrayParts parts,
                      const nb::object& progress) {
    return run(progress, [&](const Progress& callback) {
        return handle.paint.arrays(model, parts, callback);
    });
}

nb::dict appearance_arrays(const PaintHandle& handle, const Model& model, bool mean,
                           const nb::object& progress) {
    return to_dict(
        arrays_of(handle, model, mean ? bsdf::ArrayParts::mean : bsdf::ArrayParts::all, progress));
}

exchange::WebglShader webgl_shader(const PaintHandle& handle, const Model& model,
                                   const nb::object& progress) {
    return exchange::make_webgl_shader(arrays_of(handle, model, bsdf::ArrayParts::all, progress));
}

/// (N, 3) of two directions each, unit vectors above the surface.
NumpyArray<double> webgl_brdf(const exchange::WebglShader& shader, const Doubles& wi,
                              const Doubles& wo) {
    const Broadcast<2> places({&wi, &wo}, {"wi", "wo"}, 3);
    std::vector<double> values(3 * places.size());
    for (std::size_t n = 0; n < places.size(); ++n) {
        const double *i = places.at(0, n), *o = places.at(1, n);
        const Vec3d value = shader.brdf({i[0], i[1], i[2]}, {o[0], o[1], o[2]});
        for (int c = 0; c < 3; ++c) values[3 * n + c] = value[c];
    }
    return to_numpy(std::move(values), {places.size(), 3});
}

}  // namespace

void bind_appearance_arrays(nb::module_& module) {
    nb::class_<exchange::WebglShader>(module, "WebglShader")
        .def("brdf", &webgl_brdf, "wi"_a, "wo"_a);
    module.def("webgl_shader", &webgl_shader, "paint"_a, "model"_a, "progress"_a.none());
    module.def("appearance_arrays", &appearance_arrays, "paint"_a, "model"_a, "mean"_a,
               "progress"_a.none());
}

}  // namespace nacre::python
