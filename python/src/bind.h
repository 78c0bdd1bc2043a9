#pragma once

#include <nanobind/nanobind.h>

#include <map>
#include <string>

#include "nacre/bsdf/model.h"
#include "nacre/core/part.h"
#include "nacre/measure/measurement.h"

// The parts of the extensions: each adds its classes and functions to a module. The package's
// Python (python/nacre) gives them their public face; nothing here is computed twice or otherwise
// than by the front door, nacre/nacre.h.

namespace nacre::python {

namespace nb = nanobind;

/// A path as Python spells paths, whose bytes need not be UTF-8.
inline nb::object path_text(const std::string& path) {
    return nb::steal(
        PyUnicode_DecodeFSDefaultAndSize(path.data(), static_cast<Py_ssize_t>(path.size())));
}

/// A name, which is UTF-8 unless it is that of a file.
inline nb::object name_text(const std::string& name) {
    return nb::steal(
        PyUnicode_DecodeUTF8(name.data(), static_cast<Py_ssize_t>(name.size()), "surrogateescape"));
}

/// For pickling: what is between the two is nobody's business, and each class's own.
inline const nb::sig kGetStateSignature("def __getstate__(self) -> object");
inline const nb::sig kSetStateSignature("def __setstate__(self, state: object, /) -> None");

void bind_paint(nb::module_& module);
void bind_look(nb::module_& module);
void bind_appearance_arrays(nb::module_& module);
void bind_optics(nb::module_& module);
void bind_measurement(nb::module_& module);
void bind_reference(nb::module_& module);
void bind_sparkle(nb::module_& module);
void bind_fit(nb::module_& module);
void bind_drawdown(nb::module_& module);
void bind_images(nb::module_& module);

/// Turns exceptions of the library into those of nacre/_errors.py, with the same texts as the
/// command line prints.
void translate_errors();

/// The options of a model by name, as users write their values: {"hot_spot": "off"}.
using ModelChoices = std::map<std::string, std::string>;

/// The model of that name with these options.
/// @throws SettingError naming the model and those that there are, or the option and its values
bsdf::Model configured_model(const std::string& name, const ModelChoices& options);

/// The switches among the options of a model, by name, and whether they are on without any choice:
/// {"hot_spot": true}. None of a name that is no model.
std::map<std::string, bool> model_switches(const std::string& name);

/// "total", "single" or "multiple". @throws SettingError
Part part_of(const std::string& name);

/// Of a direction, in degrees. @throws SettingError naming the argument, unless in kPolarAngleRange
void require_polar_angle(const char* name, double deg);
/// The same of an azimuth, which may be any finite angle.
void require_finite_angle(const char* name, double deg);

/// The illuminant or observer of that name. @throws SettingError
spectra::Illuminant illuminant(const std::string& name);
spectra::Observer observer(const std::string& name);

}  // namespace nacre::python
