#include <nanobind/stl/optional.h>
#include <nanobind/stl/shared_ptr.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/tuple.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "arrays.h"
#include "bind.h"
#include "nacre/bsdf/leaning_flakes.h"
#include "nacre/models/models.h"
#include "nacre/nacre.h"
#include "paint_handle.h"
#include "work.h"

// What a renderer asks of a paint: samples, densities, albedo.

namespace nacre::python {

namespace {

using namespace nb::literals;
using bsdf::BoundBsdf;
using bsdf::Wavelengths;

Vec3f direction(const char* name, const double* w) {
    const double largest = std::max({std::abs(w[0]), std::abs(w[1]), std::abs(w[2])});
    const double safe = largest > 0 && std::isfinite(largest) ? largest : 1;
    const Vec3d v{w[0] / safe, w[1] / safe, w[2] / safe};  // whose square is neither 0 nor infinite
    const double length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    if (!(length > 0) || !std::isfinite(length)) {
        throw DomainError(std::string(name) + ": a direction must be finite and have a length");
    }
    return Vec3f{static_cast<float>(v[0] / length), static_cast<float>(v[1] / length),
                 static_cast<float>(v[2] / length)};
}

/// At most eight wavelengths, the last one repeated.
std::shared_ptr<const BoundBsdf> bind(const Look& look, const double* nm, std::size_t n) {
    const std::vector<double> key(nm, nm + n);
    for (const auto& [known, bound] : look.bound) {
        if (known == key) return bound;
    }
    Wavelengths lanes;
    for (std::size_t i = 0; i < lanes.size(); ++i) {
        lanes[i] = nm[std::min(i, n - 1)];
        require_in_range(lanes[i], paint::limits::kWavelength.lo, paint::limits::kWavelength.hi,
                         "wavelength in nm");
    }
    std::shared_ptr<const BoundBsdf> bound = bsdf::bind_with_lean(*look.surface, lanes);
    constexpr std::size_t kKept = 8;
    if (look.bound.size() == kKept) look.bound.erase(look.bound.begin());
    look.bound.emplace_back(key, bound);
    return bound;
}

std::shared_ptr<const BoundBsdf> bind_together(const Look& look, const Doubles& nm) {
    if (nm.size() < 1 || nm.size() > kLanes) {
        throw SettingError("wavelengths_nm", std::to_string(nm.size()) + " wavelengths; 1 to " +
                                                 std::to_string(kLanes) + " are sampled together");
    }
    return bind(look, nm.data(), nm.size());
}

nb::tuple sample(const Look& look, const Doubles& wi, const Doubles& u, const Doubles& nm) {
    const Broadcast<2> places({&wi, &u}, {"wi", "u"}, 3);
    const auto bound = bind_together(look, nm);
    const std::size_t n = places.size(), width = nm.size();
    std::vector<float> wo(places.size_with(3)), weight(places.size_with(width)), pdf(n);
    std::vector<signed char> kind(n, -1);
    for_each(n, [&](std::size_t place) {
        const Vec3f in = direction("wi", places.at(0, place));
        const double* random = places.at(1, place);
        for (int c = 0; c < 3; ++c) {
            if (!(random[c] >= 0 && random[c] < 1)) {
                throw DomainError("u: must be in [0, 1)");
            }
        }
        // A double just below 1 may round to 1.
        const auto below_1 = [](double x) {
            return std::min(static_cast<float>(x), std::nextafter(1.0f, 0.0f));
        };
        const auto drawn =
            bound->sample(in, below_1(random[0]), {below_1(random[1]), below_1(random[2])});
        if (!drawn) return;
        for (int c = 0; c < 3; ++c) wo[3 * place + static_cast<std::size_t>(c)] = drawn->wo[c];
        for (std::size_t i = 0; i < width; ++i) {
            weight[place * width + i] = drawn->weight[static_cast<int>(i)];
        }
        pdf[place] = drawn->pdf;
        kind[place] = static_cast<signed char>(drawn->kind);
    });
    return nb::make_tuple(to_numpy(std::move(wo), places.shape_with(3)),
                          to_numpy(std::move(weight), places.shape_with(width)),
                          to_numpy(std::move(pdf), places.shape()),
                          to_numpy(std::move(kind), places.shape()));
}

NumpyArray<float> pdf(const Look& look, const Doubles& wi, const Doubles& wo, const Doubles& nm) {
    const Broadcast<2> places({&wi, &wo}, {"wi", "wo"}, 3);
    const auto bound = bind_together(look, nm);
    std::vector<float> density(places.size());
    for_each(places.size(), [&](std::size_t place) {
        density[place] =
            bound->pdf(direction("wi", places.at(0, place)), direction("wo", places.at(1, place)));
    });
    return to_numpy(std::move(density), places.shape());
}

NumpyArray<float> albedo(const Look& look, const Doubles& wi, const Doubles& nm) {
    const Broadcast<1> places({&wi}, {"wi"}, 3);
    const std::size_t width = nm.size();
    std::vector<std::shared_ptr<const BoundBsdf>> blocks;
    for (std::size_t first = 0; first < width; first += kLanes) {
        blocks.push_back(
            bind(look, nm.data() + first, std::min<std::size_t>(kLanes, width - first)));
    }
    std::vector<float> values(places.size_with(width));
    for_each(places.size(), [&](std::size_t place) {
        const Vec3f in = direction("wi", places.at(0, place));
        for (std::size_t b = 0; b < blocks.size(); ++b) {
            const FloatLanes lanes = blocks[b]->albedo(in);
            for (std::size_t i = b * kLanes; i < std::min(width, (b + 1) * kLanes); ++i) {
                values[place * width + i] = lanes[static_cast<int>(i - b * kLanes)];
            }
        }
    });
    return to_numpy(std::move(values), places.shape_with(width));
}

/// Of these wavelengths those that a solution at the paint's own does not reach: then all, to be
/// solved for; else none.
/// @throws InputError if a solved paint does not reach them
SolveSettings beyond_the_usual(const Paint& paint, const std::optional<Model>& model,
                               const std::vector<double>& nm) {
    const Model shown = model.value_or(models::default_model());
    const bool solved = paint.kind() == Kind::solved_paint;
    if (!(solved || paint.kind() == Kind::recipe) || shown.makes_table() ||
        shown.info().solution == bsdf::Solution::none) {
        return {};
    }
    const std::vector<double> usual =
        solved ? paint.solved()->wavelengths_nm() : spectra::default_wavelengths_nm();
    const auto reached = [&](double w) { return w >= usual.front() && w <= usual.back(); };
    if (std::ranges::all_of(nm, reached)) return {};
    SolveSettings settings;
    settings.wavelengths_nm = nm;
    if (solved) {  // which has no others
        std::erase_if(settings.wavelengths_nm, reached);
        (void)paint.solved(settings);
    }
    return settings;
}

/// Made once and kept with the paint, as its tables take tenths of a second.
std::shared_ptr<const Look> look_of(const PaintHandle& handle, const std::optional<Model>& model,
                                    const Doubles& wavelengths_nm, const nb::object& progress) {
    const std::vector<double> nm = to_vector(wavelengths_nm);
    for (double w : nm) {
        require_in_range(w, paint::limits::kWavelength.lo, paint::limits::kWavelength.hi,
                         "wavelength in nm");
    }
    const SolveSettings solve = beyond_the_usual(handle.paint, model, nm);
    for (const auto& known : handle.looks) {
        if (known.model == model && known.solve == solve) return known.look;
    }
    const auto look = run(progress, [&](const Progress& callback) {
        return std::make_shared<const Look>(Look{handle.paint.appearance(model, solve, callback)});
    });
    constexpr std::size_t kKept = 2;
    if (handle.looks.size() == kKept) handle.looks.erase(handle.looks.begin());
    handle.looks.push_back({model, solve, look});
    return look;
}

}  // namespace

void bind_look(nb::module_& module) {
    nb::class_<Look>(module, "Look")
        .def("sample", &sample, "wi"_a, "u"_a, "wavelengths_nm"_a)
        .def("pdf", &pdf, "wi"_a, "wo"_a, "wavelengths_nm"_a)
        .def("albedo", &albedo, "wi"_a, "wavelengths_nm"_a);
    module.def("look", &look_of, "paint"_a, "model"_a.none(), "wavelengths_nm"_a,
               "progress"_a.none());
}

}  // namespace nacre::python
