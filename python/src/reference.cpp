#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

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

/// (brdf, standard error), each (lamp..., view..., wavelength).
nb::tuple reference(const PaintHandle& handle, const Doubles& theta_i_deg,
                    const Doubles& theta_o_deg, const Doubles& phi_deg,
                    const std::optional<Doubles>& wavelengths_nm, std::uint64_t samples,
                    std::uint64_t seed, const std::string& part, const nb::object& progress) {
    const Broadcast<1> lamps({&theta_i_deg}, {"theta_i_deg"}, 1);
    const Broadcast<2> views({&theta_o_deg, &phi_deg}, {"theta_o_deg", "phi_deg"}, 1);
    std::vector<Direction> incident(lamps.size()), outgoing(views.size());
    for (std::size_t i = 0; i < incident.size(); ++i) {
        incident[i] = {*lamps.at(0, i), 0};
        require_polar_angle("theta_i_deg", incident[i].theta_deg);
    }
    for (std::size_t o = 0; o < outgoing.size(); ++o) {
        outgoing[o] = {*views.at(0, o), *views.at(1, o)};
        require_polar_angle("theta_o_deg", outgoing[o].theta_deg);
        require_finite_angle("phi_deg", outgoing[o].phi_deg);
    }
    const std::vector<double> nm =
        wavelengths_nm ? to_vector(*wavelengths_nm) : spectra::default_wavelengths_nm();
    const ReferenceSettings settings{nm, {samples, seed, part_of(part)}};
    // No wavelengths are not those that the library chooses.
    const auto estimates =
        nm.empty() ? std::vector<Estimate>() : run(progress, [&](const Progress& callback) {
            return handle.paint.reference(incident, outgoing, settings, callback);
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
