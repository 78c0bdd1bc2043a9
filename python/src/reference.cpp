#include "nacre/montecarlo/reference.h"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "arrays.h"
#include "bind.h"
#include "nacre/nacre.h"
#include "nacre/spectra/spectrum.h"
#include "paint_handle.h"
#include "work.h"

// The random walk that checks the solver.

namespace nacre::python {

namespace {

using namespace nb::literals;
using montecarlo::Direction;

/// Which the recipe must not be blamed for.
double angle(const char* name, double theta_deg) {
    if (theta_deg >= 0 && theta_deg < 90) return theta_deg;
    throw SettingError(name, "must be in [0, 90) deg", std::to_string(theta_deg));
}

/// (brdf, standard error), each (lamp..., view..., wavelength).
nb::tuple reference(const PaintHandle& handle, const Doubles& theta_i_deg,
                    const Doubles& theta_o_deg, const Doubles& phi_deg,
                    const std::optional<Doubles>& wavelengths_nm, std::uint64_t samples,
                    std::uint64_t seed, const std::string& part, const nb::object& progress) {
    const Broadcast<1> lamps({&theta_i_deg}, {"theta_i_deg"}, 1);
    const Broadcast<2> views({&theta_o_deg, &phi_deg}, {"theta_o_deg", "phi_deg"}, 1);
    std::vector<Direction> incident(lamps.size()), outgoing(views.size());
    for (std::size_t i = 0; i < incident.size(); ++i) {
        incident[i] = {angle("theta_i_deg", *lamps.at(0, i)), 0};
    }
    for (std::size_t o = 0; o < outgoing.size(); ++o) {
        outgoing[o] = {angle("theta_o_deg", *views.at(0, o)), *views.at(1, o)};
        if (!std::isfinite(outgoing[o].phi_deg)) throw SettingError("phi_deg", "must be finite");
    }
    const std::vector<double> nm =
        wavelengths_nm ? to_vector(*wavelengths_nm) : spectra::default_wavelengths_nm();
    for (const double wavelength : nm) {
        require_in_range(wavelength, paint::limits::kWavelength.lo, paint::limits::kWavelength.hi,
                         "wavelength in nm");
    }
    constexpr std::uint64_t kMaxSamples = 1'000'000'000'000'000;
    if (samples < 2 || samples > kMaxSamples) {
        throw SettingError("samples", "must be in [2, 1e15]", std::to_string(samples));
    }
    const montecarlo::ReferenceSettings settings{samples, seed, part_of(part)};
    const paint::Recipe& recipe = handle.paint.recipe();
    const auto estimates = run(progress, [&](const Progress& callback) {
        try {
            return montecarlo::reference_brdf(recipe, incident, outgoing, nm, settings, callback);
        } catch (const DomainError& error) {  // the rest has been checked: it is the recipe
            throw InputError(handle.paint.file() + ": " + error.what());
        }
    });
    std::vector<double> values, errors;
    for (const Estimate& estimate : estimates) {
        values.push_back(estimate.value);
        errors.push_back(estimate.standard_error);
    }
    Shape shape = lamps.shape();
    shape.insert(shape.end(), views.shape().begin(), views.shape().end());
    shape.push_back(nm.size());
    return nb::make_tuple(to_numpy(std::move(values), shape), to_numpy(std::move(errors), shape));
}

}  // namespace

void bind_reference(nb::module_& module) {
    module.def("reference", &reference, "paint"_a, "theta_i_deg"_a, "theta_o_deg"_a, "phi_deg"_a,
               "wavelengths_nm"_a.none(), "samples"_a, "seed"_a, "part"_a, "progress"_a.none());
}

}  // namespace nacre::python
