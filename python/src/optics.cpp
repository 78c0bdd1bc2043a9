#include <nanobind/stl/complex.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <complex>

#include "arrays.h"
#include "bind.h"
#include "nacre/core/math.h"
#include "nacre/nacre.h"
#include "nacre/optics/material.h"
#include "nacre/optics/thin_film.h"
#include "nacre/spectra/colour.h"
#include "work.h"

// Materials, films and colours.

namespace nacre::python {

namespace {

using namespace nb::literals;
using optics::Material;
using optics::Polarization;

NumpyArray<std::complex<double>> index_of(const Material& material, const Doubles& nm) {
    const Broadcast<1> places({&nm}, {"wavelengths_nm"}, 1);
    Unwritten<std::complex<double>> values(nm.size());
    for_each(nm.size(), [&](std::size_t i) { *values.at(i) = material.index(nm.data()[i]); });
    return std::move(values).to_numpy(places.shape());
}

Polarization polarization_of(const std::string& text) {
    if (text == "s") return Polarization::s;
    if (text == "p") return Polarization::p;
    if (text == "u") return Polarization::unpolarized;
    throw SettingError("polarization", "must be s, p or u", text);
}

nb::tuple film(const Material& ambient, const std::vector<Material>& materials,
               const std::vector<double>& thickness_nm, const Material& substrate,
               const Doubles& angle_deg, const Doubles& wavelengths_nm,
               const std::string& polarization) {
    const Broadcast<1> places({&angle_deg}, {"angle_deg"}, 1);
    const Polarization polarized = polarization_of(polarization);
    const std::size_t width = wavelengths_nm.size(), films = materials.size();
    if (thickness_nm.size() != films) throw DomainError("a film has no thickness");
    for (std::size_t i = 0; i < places.size(); ++i) {
        require_in_range(*places.at(0, i), optics::kIncidenceRange.lo, optics::kIncidenceRange.hi,
                         "angle in deg");
    }
    // What depends on the wavelength alone, before the loop.
    std::vector<optics::ComplexIndex> above(width), below(width);
    std::vector<optics::ThinFilm> stacks(width * films);
    for_each(width, [&](std::size_t w) {
        const double nm = wavelengths_nm.data()[w];
        above[w] = ambient.index(nm);
        below[w] = substrate.index(nm);
        for (std::size_t i = 0; i < films; ++i) {
            stacks[w * films + i] = {materials[i].index(nm), thickness_nm[i]};
        }
    });
    std::vector<double> r(places.size_with(width)), t(r.size());
    for_each(places.size(), [&](std::size_t place) {
        const double cosine = std::cos(*places.at(0, place) * std::numbers::pi / 180);
        for (std::size_t w = 0; w < width; ++w) {
            const optics::ReflectanceTransmittance rt =
                optics::stack_reflectance(above[w], {stacks.data() + w * films, films}, below[w],
                                          cosine, wavelengths_nm.data()[w], polarized);
            r[place * width + w] = rt.reflectance;
            t[place * width + w] = rt.transmittance;
        }
    });
    const Shape shape = places.shape_with(width);
    return nb::make_tuple(to_numpy(std::move(r), shape), to_numpy(std::move(t), shape));
}

Vec3d triple(const double* v) { return {v[0], v[1], v[2]}; }

/// A function of triples, for arrays of them.
template <class F>
NumpyArray<double> map_triples(const Doubles& in, const char* name, const F& f) {
    const Broadcast<1> places({&in}, {name}, 3);
    std::vector<double> out(places.size_with(3));
    for_each(places.size(), [&](std::size_t i) {
        const Vec3d value = f(triple(places.at(0, i)));
        for (int c = 0; c < 3; ++c) out[3 * i + static_cast<std::size_t>(c)] = value[c];
    });
    return to_numpy(std::move(out), places.shape_with(3));
}

/// XYZ and L*a*b* of reflectance factors (..., W), as instruments state them.
nb::tuple colours(const Doubles& wavelengths_nm, const Doubles& reflectance,
                  const std::string& illuminant_name, const std::string& observer_name) {
    const std::vector<double> nm = to_vector(wavelengths_nm);
    if (nm.size() < 2) throw DomainError("wavelengths_nm: at least two are needed");
    const Broadcast<1> places({&reflectance}, {"reflectance"}, nm.size());
    const measure::Conditions conditions{illuminant(illuminant_name), observer(observer_name), {}};
    std::vector<double> xyz(places.size_with(3)), lab(xyz.size());
    for_each(places.size(), [&](std::size_t i) {
        const double* r = places.at(0, i);
        const measure::Reading reading = measure::coloured({}, nm, {r, r + nm.size()}, conditions);
        for (int c = 0; c < 3; ++c) {
            const std::size_t at = 3 * i + static_cast<std::size_t>(c);
            xyz[at] = reading.xyz[c];
            lab[at] = reading.lab[c];
        }
    });
    const Shape shape = places.shape_with(3);
    return nb::make_tuple(to_numpy(std::move(xyz), shape), to_numpy(std::move(lab), shape));
}

NumpyArray<double> delta_e_2000(const Doubles& lab1, const Doubles& lab2) {
    const Broadcast<2> places({&lab1, &lab2}, {"lab1", "lab2"}, 3);
    std::vector<double> values(places.size());
    for_each(values.size(), [&](std::size_t i) {
        values[i] = spectra::delta_e_2000(triple(places.at(0, i)), triple(places.at(1, i)));
    });
    return to_numpy(std::move(values), places.shape());
}

}  // namespace

void bind_optics(nb::module_& module) {
    nb::class_<Material>(module, "Material")
        .def(nb::new_([](const std::string& name) { return optics::find_material(name); }),
             "name"_a)
        .def_static(
            "constant", [](std::complex<double> index) { return Material(index); }, "index"_a)
        .def_static(
            "sampled",
            [](const std::string& name, const Doubles& nm, const Doubles& n, const Doubles& k) {
                if (n.size() != nm.size() || k.size() != nm.size()) {
                    throw DomainError(name + ": wavelengths, n and k must be as many");
                }
                std::vector<optics::ComplexIndex> index(nm.size());
                for (std::size_t i = 0; i < nm.size(); ++i) {
                    index[i] = {n.data()[i], k.data()[i]};
                }
                return Material(name, to_vector(nm), std::move(index));
            },
            "name"_a, "wavelengths_nm"_a, "n"_a, "k"_a)
        .def("state",
             [](const Material& m) {
                 return nb::make_tuple(m.name(), m.source(), m.wavelengths_nm(), m.samples());
             })
        .def_static(
            "from_state",
            [](const std::string& name, const std::string& source, const std::vector<double>& nm,
               const std::vector<std::complex<double>>& index) {
                if (nm.empty()) return Material(name, index.at(0), source);
                return Material(name, nm, index, source);
            },
            "name"_a, "source"_a, "wavelengths_nm"_a, "index"_a)
        .def_prop_ro("name", [](const Material& m) { return m.name(); })
        .def_prop_ro("source", [](const Material& m) { return m.source(); })
        .def_prop_ro(
            "wavelengths_nm",
            [](const Material& m) { return to_numpy(std::vector<double>(m.wavelengths_nm())); },
            kOwned)
        .def("index", &index_of, "wavelengths_nm"_a);
    module.def("material_names", &optics::material_names);
    module.def("film", &film, "ambient"_a, "materials"_a, "thickness_nm"_a, "substrate"_a,
               "angle_deg"_a, "wavelengths_nm"_a, "polarization"_a);
    module.def("colours", &colours, "wavelengths_nm"_a, "reflectance"_a, "illuminant"_a,
               "observer"_a);
    module.def("delta_e_2000", &delta_e_2000, "lab1"_a, "lab2"_a);
    module.def(
        "srgb_chip",
        [](const Doubles& lab, bool full_light) {
            return map_triples(lab, "lab", [&](const Vec3d& v) {
                return full_light ? measure::srgb_chip_at_full_light(v) : measure::srgb_chip(v);
            });
        },
        "lab"_a, "full_light"_a);
}

}  // namespace nacre::python
