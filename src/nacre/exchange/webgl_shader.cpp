#include "nacre/exchange/webgl_shader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/half.h"
#include "nacre/core/parallel.h"
#include "nacre/core/sha256.h"
#include "nacre/exchange/webgl_layout.h"
#include "nacre/spectra/colour.h"

namespace nacre::exchange {

namespace {

/// Where n even places from 0 to 1 fall among m even ones: linear interpolation.
struct EvenPlaces {
    std::size_t low, high;
    double part;

    EvenPlaces(std::size_t k, std::size_t n, std::size_t m) {
        const double at =
            static_cast<double>(k) * static_cast<double>(m - 1) / static_cast<double>(n - 1);
        low = std::min(static_cast<std::size_t>(at), m > 1 ? m - 2 : 0);
        high = std::min(low + 1, m - 1);
        part = at - static_cast<double>(low);
    }
};

using spectra::Illuminant;

/// Weights of the samples of a reflectance in its colour under a lamp, linear Rec. 709 for the 2 degree
/// observer, as the renderer's film has it: by the light between the first and the last wavelength
/// alone, of which the perfect diffuser is white, also to an eye that has adapted to another lamp than
/// D65 (spectra::adapted).
std::vector<Vec3d> film_weights(const std::vector<double>& wavelengths_nm, Illuminant lamp) {
    constexpr auto kObserver = spectra::Observer::cie1931_2deg;
    std::vector<double> fine_nm;
    for (double nm = wavelengths_nm.front(); nm < wavelengths_nm.back() + 0.5; nm += 1) {
        fine_nm.push_back(nm);
    }
    const Vec3d rec709_white = spectra::linear_rec709_to_xyz({1, 1, 1});
    const Vec3d film_white = spectra::white_point(fine_nm, Illuminant::D65, kObserver);
    const auto on_film = [&](Vec3d xyz) {
        for (int c = 0; c < 3; ++c) xyz[c] *= rec709_white[c] / film_white[c];
        return xyz;
    };
    const Vec3d white = on_film(spectra::white_point(fine_nm, lamp, kObserver));
    std::vector<Vec3d> weights;
    std::vector<double> hat(wavelengths_nm.size(), 0.0), fine(fine_nm.size());
    for (double& sample : hat) {
        sample = 1;
        const spectra::Spectrum spectrum(wavelengths_nm, hat);
        sample = 0;
        std::transform(fine_nm.begin(), fine_nm.end(), fine.begin(), spectrum);
        const Vec3d xyz = on_film(spectra::reflectance_to_xyz(fine_nm, fine, lamp, kObserver));
        weights.push_back(
            spectra::xyz_to_linear_rec709(spectra::adapted(xyz, white, rec709_white)));
    }
    return weights;
}

/// Fills the layout, and with it the table.
class Tabulator {
 public:
    /// @param flakes  one by one too: arrays.species
    Tabulator(const bsdf::NacreArrays& arrays, bool flakes, Illuminant lamp)
        : arrays_(arrays),
          flakes_(flakes),
          lamp_(lamp),
          bands_(webgl_bands(arrays.wavelengths_nm)) {
        std::vector<double> bands_nm;
        for (const WebglBand& band : bands_) bands_nm.push_back(band.nm);
        const std::vector<Vec3d> weights = film_weights(bands_nm, lamp);
        for (int b = 0; b < kWebglBands; ++b) {
            for (int c = 0; c < 3; ++c) layout_.rgb[c][b] = static_cast<float>(weights[b][c]);
        }
        fill();
        if (flakes_) add_species();
    }

    WebglShader::Layout layout() && { return std::move(layout_); }

    WebglTexture table() const {
        WebglTexture out{"nacreTable", {static_cast<int>(4 * channels_.size()), kWebglRows}, {}};
        if (4 * channels_.size() > kMaxTextureSize) {
            throw DomainError(
                fmt::format("paint: its species need a texture {} wide; must be at most {}",
                            4 * channels_.size(), kMaxTextureSize));
        }
        out.rgba.reserve(channels_.size() * kWebglRows * kWebglBands);
        for (int row = 0; row < kWebglRows; ++row) {
            for (const std::vector<double>& channel : channels_) {
                for (int b = 0; b < kWebglBands; ++b) {
                    out.rgba.push_back(checked_half(channel[row * kWebglBands + b]));
                }
            }
        }
        return out;
    }

 private:
    template <class T>
    Bands at_bands(const std::vector<T>& values) const {
        Bands out;
        for (int b = 0; b < kWebglBands; ++b) {
            out[b] = static_cast<float>(bands_[b].of(values.data()));
        }
        return out;
    }

    /// Of functions of an even place, (rows, kWebglBands).
    int add(const std::vector<double>& values) {
        const std::size_t rows = values.size() / kWebglBands;
        std::vector<double>& channel = channels_.emplace_back();
        channel.reserve(std::size_t{kWebglRows} * kWebglBands);
        for (int row = 0; row < kWebglRows; ++row) {
            const EvenPlaces at(row, kWebglRows, rows);
            for (int b = 0; b < kWebglBands; ++b) {
                channel.push_back(values[at.low * kWebglBands + b] * (1 - at.part) +
                                  values[at.high * kWebglBands + b] * at.part);
            }
        }
        return static_cast<int>(channels_.size()) - 1;
    }
    /// Of values (rows, W), each multiplied by factor(w).
    template <class T, class Factor>
    int add_spectra(const std::vector<T>& values, const Factor& factor) {
        const std::size_t count = arrays_.wavelengths_nm.size();
        std::vector<double> bands, row(count);
        for (std::size_t first = 0; first < values.size(); first += count) {
            for (std::size_t w = 0; w < count; ++w) row[w] = values[first + w] * factor(w);
            for (const WebglBand& band : bands_) bands.push_back(band.of(row.data()));
        }
        return add(bands);
    }
    template <class T>
    int add_spectra(const std::vector<T>& values) {
        return add_spectra(values, [](std::size_t) { return 1.0; });
    }

    void fill() {
        layout_.ior = arrays_.mean_ior;
        layout_.roughness = arrays_.coat_roughness;
        layout_.clearcoat_depth = at_bands(arrays_.clearcoat_depth);
        double top_um = 0;
        for (const bsdf::NacreArrays::Layer& from : arrays_.layers) {
            layout_.layers.push_back(layer(from, top_um));
            top_um += from.thickness_um;
        }
        // Under a rough coat, whose table has the mean with it, it is for single flakes.
        if (arrays_.hot_spot && (layout_.roughness == 0 || flakes_)) {
            for (const auto& species : arrays_.hot_spot->species) {
                layout_.gaps.push_back(
                    {species.layer, species.diameter_um, add_spectra(species.coupling)});
            }
            const auto& [species, ground, compensation] = *arrays_.hot_spot;
            if (!compensation.empty()) {
                layout_.compensation = add_spectra(compensation);
                // Black as well, so that a substrate's reflectance changes no text.
                layout_.ground = ground.empty() ? add(std::vector<double>(kWebglBands, 0.0))
                                                : add_spectra(ground);
            }
        }
        if (!arrays_.albedo.empty()) layout_.albedo = add_albedo();
        if (layout_.roughness > 0) {
            layout_.masked = add_spectra(
                arrays_.masked, [&](std::size_t w) { return std::sqrt(arrays_.diffuse_scale[w]); });
            std::vector<double> masking;
            for (const double value : arrays_.masking_over_cosine) {
                masking.insert(masking.end(), kWebglBands, value);
            }
            layout_.masking = add(masking);
        }
        add_lobes();
    }

    WebglShader::Layout::Layer layer(const bsdf::NacreArrays::Layer& from, double top_um) {
        WebglShader::Layout::Layer to{
            from.thickness_um, top_um, add_spectra(from.extinction_per_um), {}, {}};
        for (const bsdf::NacreArrays::Flake& flake : from.flakes) {
            const double scale = 0.5 * flake.area_density_per_um /
                                 (2 * std::numbers::pi * flake.alpha * flake.alpha);
            to.flakes.push_back({add_spectra(flake.reflectance), scale, flake.alpha});
        }
        for (const bsdf::NacreArrays::Pigment& pigment : from.pigments) {
            std::optional<int> phase;
            if (!pigment.phase.empty()) phase = add_spectra(pigment.phase);
            to.pigments.push_back({pigment.anisotropy, at_bands(pigment.scattering_per_um), phase});
        }
        return to;
    }

    int add_albedo() {
        const std::vector<double>& nm = arrays_.wavelengths_nm;
        const std::vector<Vec3d> weights = film_weights(nm, lamp_);
        std::vector<double> bands;
        for (std::size_t first = 0; first < arrays_.albedo.size(); first += nm.size()) {
            Vec3d rgb;
            for (std::size_t w = 0; w < nm.size(); ++w) {
                rgb += static_cast<double>(arrays_.albedo[first + w]) * weights[w];
            }
            for (int b = 0; b < kWebglBands; ++b) bands.push_back(b < 3 ? rgb[b] : 0);
        }
        return add(bands);
    }

    void add_species() {
        std::size_t species = 0;
        for (std::size_t l = 0; l < layout_.layers.size(); ++l) {
            for (const auto& flake : layout_.layers[l].flakes) {
                const bsdf::NacreArrays::Species& from = arrays_.species[species++];
                std::vector<double> bands(std::size_t{kWebglRows} * kWebglBands, 0.0);
                for (std::size_t n = 0; n < from.diameter_um.size(); ++n) {
                    bands[n * kWebglBands] = from.diameter_um[n];
                }
                layout_.species.push_back({from.field, l, add(bands), flake.reflectance});
            }
        }
    }

    /// Those of flakes, evenly among their widths where there are many, and a rough coat's.
    void add_lobes() {
        std::vector<WebglShader::Layout::Lobe> all;
        for (const auto& layer : layout_.layers) {
            for (const auto& flake : layer.flakes) {
                all.push_back({std::hypot(flake.alpha, 0.5 * layout_.roughness), layout_.ior});
            }
        }
        std::sort(all.begin(), all.end());
        all.erase(std::unique(all.begin(), all.end()), all.end());
        const std::size_t count =
            std::min<std::size_t>(all.size(), WebglShader::Layout::kMaxLobes - 1);
        for (std::size_t k = 0; k < count; ++k) {
            layout_.lobes.push_back(all[count > 1 ? k * (all.size() - 1) / (count - 1) : 0]);
        }
        if (layout_.roughness > 0) layout_.lobes.push_back({layout_.roughness, 1});
        if (layout_.lobes.empty()) layout_.lobes.push_back({0.8, 1});
    }

    const bsdf::NacreArrays& arrays_;
    const bool flakes_;
    const Illuminant lamp_;
    const std::array<WebglBand, kWebglBands> bands_;
    WebglShader::Layout layout_;
    std::vector<std::vector<double>> channels_;  // [row][band]
};

WebglTexture smooth_texture(const bsdf::NacreArrays& arrays, Illuminant lamp) {
    const std::vector<Vec3d> weights = film_weights(arrays.wavelengths_nm, lamp);
    const std::size_t rank = static_cast<std::size_t>(arrays.rank), count = weights.size();
    const std::size_t first_single = rank - static_cast<std::size_t>(arrays.single_rank);
    std::vector<Vec3f> basis(rank);
    for (std::size_t k = 0; k < rank; ++k) {
        Vec3d rgb;
        for (std::size_t w = 0; w < count; ++w) {
            rgb += arrays.smooth_basis[k * count + w] * weights[w];
        }
        basis[k] = {static_cast<float>(rgb.x), static_cast<float>(rgb.y),
                    static_cast<float>(rgb.z)};
    }
    WebglTexture out{"nacreSmooth", {arrays.grid.q, arrays.grid.b, arrays.grid.a}, {}};
    out.rgba.resize(4 * arrays.grid.cells());
    constexpr std::size_t kGrain = 4096;
    parallel_for_ranges(0, arrays.grid.cells(), kGrain, [&](std::size_t first, std::size_t last) {
        const float* coefficient = arrays.smooth.data() + first * rank;
        std::uint16_t* to = out.rgba.data() + 4 * first;
        for (std::size_t cell = first; cell < last; ++cell, coefficient += rank) {
            Vec3f rgb, single;
            for (std::size_t k = 0; k < rank; ++k) {
                rgb += coefficient[k] * basis[k];
                if (k >= first_single) single += coefficient[k] * basis[k];
            }
            for (int c = 0; c < 3; ++c) *to++ = checked_half(rgb[c]);
            *to++ = checked_half(spectra::rec709_luminance(single.x, single.y, single.z));
        }
    });
    return out;
}

/// In the order in which they are declared, without empty arrays, which GLSL does not know.
std::vector<WebglUniform> uniforms_of(const WebglShader::Layout& layout) {
    const auto number = [](const char* name, double value) {
        return WebglUniform{name, 1, false, {static_cast<float>(value)}};
    };
    const auto bands = [](const char* name, const Bands& values) {
        return WebglUniform{name, 4, true, {values.begin(), values.end()}};
    };
    const auto add = [](WebglUniform& list, std::initializer_list<double> values) {
        for (const double x : values) list.values.push_back(static_cast<float>(x));
    };
    WebglUniform layers{"nacreLayer", 2, true, {}};  // thickness and top, um
    WebglUniform flakes{"nacreFlake", 2, true, {}};  // Flake::scale and alpha
    WebglUniform anisotropy{"nacreAnisotropy", 1, true, {}};
    WebglUniform scattering{"nacreScattering", 4, true, {}};
    WebglUniform gaps{"nacreGap", 1, true, {}};  // diameter, um
    WebglUniform lobes{"nacreLobes", 2, true, {}};
    for (const auto& layer : layout.layers) {
        add(layers, {layer.thickness_um, layer.top_um});
        for (const auto& flake : layer.flakes) add(flakes, {flake.scale, flake.alpha});
        for (const auto& pigment : layer.pigments) {
            add(anisotropy, {pigment.anisotropy});
            for (const float x : pigment.scattering_per_um) add(scattering, {x});
        }
    }
    for (const auto& species : layout.gaps) add(gaps, {species.diameter_um});
    for (std::size_t k = 0; k < WebglShader::Layout::kMaxLobes; ++k) {
        const auto& lobe = layout.lobes[std::min(k, layout.lobes.size() - 1)];
        add(lobes, {lobe.alpha, lobe.ior});
    }
    std::vector<WebglUniform> all = {
        number("nacreIor", layout.ior),
        number("nacreRoughness", layout.roughness),
        bands("nacreRed", layout.rgb[0]),
        bands("nacreGreen", layout.rgb[1]),
        bands("nacreBlue", layout.rgb[2]),
        bands("nacreDepth", layout.clearcoat_depth),
        layers,
        flakes,
        anisotropy,
        scattering,
        gaps,
        lobes,
        number("nacreLobeCount", static_cast<double>(layout.lobes.size()))};
    std::erase_if(all, [](const WebglUniform& u) { return u.values.empty(); });
    return all;
}

std::string declarations(const std::vector<WebglUniform>& uniforms) {
    std::string text;
    for (const WebglUniform& u : uniforms) {
        const auto size = static_cast<std::size_t>(u.components);
        text +=
            fmt::format("uniform {} {}", size == 1 ? "float" : fmt::format("vec{}", size), u.name);
        if (u.array) text += fmt::format("[{}]", u.values.size() / size);
        text += ";\n";
    }
    return text;
}

WebglShader make_shader(const bsdf::NacreArrays& arrays, bool flakes, Illuminant lamp) {
    Tabulator tabulator(arrays, flakes, lamp);
    WebglShader shader;
    shader.textures = {tabulator.table(), smooth_texture(arrays, lamp)};
    const auto layout = std::make_shared<const WebglShader::Layout>(std::move(tabulator).layout());
    shader.layout = layout;
    shader.uniforms = uniforms_of(*layout);
    if (!layout->species.empty()) {
        for (WebglUniform& u : webgl_flake_uniforms(arrays.species)) {
            shader.uniforms.push_back(std::move(u));
        }
        shader.textures.push_back(webgl_lobe_shapes());
    }
    shader.glsl = webgl_glsl(*layout, declarations(shader.uniforms));
    shader.program = sha256_hex(shader.glsl);
    shader.smooth_coat = layout->roughness == 0;
    return shader;
}

}  // namespace

std::array<WebglBand, kWebglBands> webgl_bands(const std::vector<double>& nm) {
    if (nm.size() < 2) {
        throw DomainError(
            fmt::format("wavelengths_nm: {}; a material in RGB needs two or more", nm.size()));
    }
    std::array<WebglBand, kWebglBands> bands;
    for (int b = 0; b < kWebglBands; ++b) {
        const double at = nm.front() + (nm.back() - nm.front()) * b / (kWebglBands - 1);
        const auto above = std::upper_bound(nm.begin() + 1, nm.end() - 1, at);
        const std::size_t low = static_cast<std::size_t>(above - nm.begin()) - 1;
        bands[b] = {at, low, (at - nm[low]) / (nm[low + 1] - nm[low])};
    }
    return bands;
}

std::uint16_t checked_half(double value) {
    const std::uint16_t bits = half_bits(static_cast<float>(value));
    if (!is_finite_half(bits)) {
        throw DomainError(fmt::format(
            "paint: its value {:.4g} is beyond the half floats of textures, 65504", value));
    }
    return bits;
}

WebglShader make_webgl_shader(const bsdf::NacreArrays& arrays, Illuminant lamp) {
    return make_shader(arrays, false, lamp);
}

WebglShader make_live_webgl_shader(const std::shared_ptr<const solver::SolvedPaint>& paint,
                                   std::uint64_t specimen, Illuminant lamp) {
    paint::require_no_lean(paint->recipe, "the live picture is of paints that are");
    return make_shader(bsdf::nacre_live_arrays(paint, specimen), true, lamp);
}

WebglFilms make_live_webgl_films(const solver::SolvedPaint& paint, const Progress& progress) {
    SharedProgress work(progress, 1);
    work.add(0);
    bsdf::FlakeFilmGrid grid{{}, kWebglFilmIntervals};
    for (const WebglBand& band : webgl_bands(paint.wavelengths_nm())) {
        grid.wavelengths_nm.push_back(band.nm);
    }
    return webgl_films(bsdf::species_films(paint, grid, &work));
}

}  // namespace nacre::exchange
