#include "nacre/fit/drawdown.h"

#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "arrays.h"
#include "bind.h"
#include "nacre/core/file.h"
#include "nacre/io/drawdown_file.h"
#include "nacre/io/pigment_file.h"
#include "nacre/nacre.h"
#include "work.h"

// From drawdowns to pigments.

namespace nacre::python {

namespace {

using namespace nb::literals;

measure::DrawdownGeometry geometry_of(const std::string& text) {
    const std::vector<std::string> words = fit::drawdown_geometry_words();
    const auto found = std::find(words.begin(), words.end(), text);
    if (found == words.end()) {
        throw SettingError("geometry", "must be d8-included, d8-excluded or 45-0", text);
    }
    return static_cast<measure::DrawdownGeometry>(found - words.begin());
}

/// NaN: not known.
NumpyArray<double> errors_of(const std::vector<std::optional<double>>& errors) {
    std::vector<double> values;
    for (const std::optional<double>& error : errors) {
        values.push_back(error.value_or(std::numeric_limits<double>::quiet_NaN()));
    }
    return to_numpy(std::move(values));
}

nb::dict estimate_of(const fit::PigmentEstimate& estimate, double anisotropy,
                     const std::string& name, const std::string& source) {
    nb::dict result;
    result["wavelengths_nm"] = to_numpy(std::vector<double>(estimate.wavelengths_nm));
    result["scattering_per_mm"] = to_numpy(std::vector<double>(estimate.scattering_per_mm));
    result["absorption_per_mm"] = to_numpy(std::vector<double>(estimate.absorption_per_mm));
    result["scattering_error"] = errors_of(estimate.scattering_error);
    result["absorption_error"] = errors_of(estimate.absorption_error);
    result["noise"] = estimate.noise;
    result["rms_residual"] = estimate.rms_residual;
    result["hidden_nm"] = to_numpy(std::vector<double>(estimate.hidden_nm));
    result["absorption_only_nm"] = to_numpy(std::vector<double>(estimate.absorption_only_nm));
    result["scattering_assumed"] = estimate.scattering_assumed;
    nb::list drawdowns;
    for (const fit::DrawdownResidual& residual : estimate.residuals) {
        nb::dict one;
        one["ground"] = residual.ground;
        one["thickness_um"] = residual.thickness_um;
        one["volume_fraction"] = residual.volume_fraction;
        one["white_volume_fraction"] = residual.white_volume_fraction;
        one["opaque"] = residual.opaque;
        one["measured"] = to_numpy(std::vector<double>(residual.measured));
        one["modelled"] = to_numpy(std::vector<double>(residual.modelled));
        one["dE2000"] = residual.delta_e_2000;
        drawdowns.append(one);
    }
    result["drawdowns"] = drawdowns;
    result["toml"] = io::write_pigment_file({estimate.pigment(name, anisotropy), source});
    return result;
}

/// What is not UTF-8 in it replaced, as files are in UTF-8.
std::string utf8_of(const std::filesystem::path& path) {
    const std::string text = path.string();
    return nb::cast<std::string>(nb::steal(
        PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace")));
}

}  // namespace

void bind_drawdown(nb::module_& module) {
    module.def(
        "pigment",
        [](const std::filesystem::path& path, const std::string& geometry,
           const optics::Material& binder, double anisotropy, bool matt_ground,
           const std::optional<double>& noise, const std::optional<std::filesystem::path>& white,
           const std::string& name, const nb::object& progress) {
            const measure::Drawdown drawdown = io::read_drawdown(path);
            fit::DrawdownSettings settings;
            settings.geometry = geometry_of(geometry);
            settings.binder = binder;
            settings.anisotropy = anisotropy;
            settings.matt_ground = matt_ground;
            settings.noise = noise;
            if (white) settings.white = io::find_white(white->string());
            const fit::PigmentEstimate estimate = run(progress, [&](const Progress& callback) {
                return fit::estimate_pigment(drawdown, settings, callback);
            });
            return estimate_of(estimate, anisotropy, name, "drawdown " + utf8_of(path));
        },
        "path"_a, "geometry"_a, "binder"_a, "anisotropy"_a, "matt_ground"_a, "noise"_a.none(),
        "white"_a.none(), "name"_a, "progress"_a.none());
}

}  // namespace nacre::python
