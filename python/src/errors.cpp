#include <nanobind/nanobind.h>

#include <exception>
#include <string>

#include "bind.h"
#include "nacre/core/text.h"
#include "nacre/nacre.h"

namespace nacre::python {

namespace {

/// Raises one of the package's own exceptions.
void raise(const char* name, const std::exception& error, const char* setting = nullptr) {
    const std::string text = printable(error.what());
    const nb::object message = nb::steal(
        PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace"));
    const nb::object type = nb::module_::import_("nacre._errors").attr(name);
    const nb::object exception = type(message);
    if (setting) exception.attr("setting") = setting;
    PyErr_SetObject(type.ptr(), exception.ptr());
}

void translate(const std::exception_ptr& thrown, void*) {
    try {
        std::rethrow_exception(thrown);
    } catch (const SettingError& error) {
        raise("SettingError", error, error.setting().c_str());
    } catch (const DomainError& error) {
        raise("DomainError", error);
    } catch (const InputError& error) {
        raise("InputError", error);
    } catch (const Stopped& error) {
        raise("Stopped", error);
    } catch (const Error& error) {
        raise("Error", error);
    }
}

}  // namespace

void translate_errors() { nb::register_exception_translator(translate); }

}  // namespace nacre::python
