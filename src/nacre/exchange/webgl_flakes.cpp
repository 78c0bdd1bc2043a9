#include <algorithm>
#include <array>
#include <cmath>

#include "nacre/core/error.h"
#include "nacre/core/half.h"
#include "nacre/core/parallel.h"
#include "nacre/exchange/webgl_layout.h"
#include "nacre/sparkle/diffraction_lobe.h"
#include "nacre/sparkle/flake_plane.h"

namespace nacre::exchange {

extern const char* const kWebglFlakes;  // webgl_flakes.glsl

namespace {

using sparkle::DiffractionLobe;
using Constants = sparkle::FlakeField::Constants;

/// const TYPE NAME[] = ... of GLSL.
template <class Numbers, class Text>
std::string glsl_array(const char* type, const Numbers& numbers, const Text& text) {
    std::string elements;
    for (const auto& x : numbers) elements += (elements.empty() ? "" : ", ") + text(x);
    return fmt::format("{}[]({})", type, elements);
}

/// The body of nacreCount(): four comparisons at a time.
std::string counts_text(const Constants& field) {
    static_assert(Constants::kMaxFlakesPerCell % 4 == 0);
    WebglLines lines;
    for (std::size_t n = 0; n < field.cumulative.size(); n += 4) {
        const float* const p = &field.cumulative[n];
        if (p[0] >= 1) break;  // never drawn
        lines.add("count += vec4(lessThanEqual(vec4({}, {}, {}, {}), vec4(draw)));",
                  glsl_number(p[0]), glsl_number(p[1]), glsl_number(p[2]), glsl_number(p[3]));
    }
    return std::move(lines).text();
}

/// The body of nacreFlakeColour(): the layers above a flake, and what it reflects.
std::string flake_layers_text(const WebglShader::Layout& layout) {
    WebglLines lines;
    webgl_gaps(layout, lines);
    for (std::size_t n = 0; n < layout.layers.size(); ++n) {
        lines.add_for_groups(fmt::format("here[@] = nacreLayer[{}].x * nacreRate({}, @, p);", n,
                                         layout.layers[n].extinction));
        if (!layout.layers[n].flakes.empty()) {
            lines.add("if (NACRE_LAYERS[s] == {}) {{", n);
            const std::string gain = webgl_gain(layout, n, "place", "    ", lines);
            lines.add_for_groups(fmt::format(
                "    sum += nacreRgb(nacreRow(NACRE_REFLECTANCES[s], @, p.cosine) * "
                "nacreFilm(s, @, p.cosine, body.y) * exp({} - depth[@] - here[@] * place), @);",
                gain));
            lines.add("    sum *= nacreLayer[{}].x;", n);
            lines.add("}}");
        }
        lines.add_for_groups("depth[@] += here[@];");
    }
    return std::move(lines).text();
}

}  // namespace

std::string webgl_flakes_glsl(const WebglShader::Layout& layout) {
    const Constants& field = layout.species.front().field;
    const auto number = [](double x) { return glsl_number(x); };
    const auto of_species = [&](auto member) {
        return glsl_array("int", layout.species,
                          [&](const auto& species) { return fmt::format("{}", species.*member); });
    };
    using Species = WebglShader::Layout::Species;
    std::string text = kWebglFlakes;
    const auto put = [&](const char* name, const std::string& value) {
        replace_all(text, fmt::format("@{}@", name), value);
    };
    put("LEVEL_COUNT", fmt::format("{}", Constants::kLevels));
    put("DENSEST", number(field.fraction[0]));
    put("COUNTS", counts_text(field));
    put("FINEST_CELLS", fmt::format("{}, {}", number(Constants::kFinestCells[0]),
                                    number(Constants::kFinestCells[1])));
    put("SIZES", of_species(&Species::sizes));
    put("OWN_LAYERS", of_species(&Species::layer));
    put("REFLECTANCES", of_species(&Species::reflectance));
    put("EXTINCTIONS", glsl_array("int", layout.species, [&](const Species& species) {
            return fmt::format("{}", layout.layers[species.layer].extinction);
        }));
    put("FILM_INTERVALS", fmt::format("{}", kWebglFilmIntervals));
    put("LOBE_POWER", number(DiffractionLobe::kLobePower));
    put("MAX_EXPONENT", number(DiffractionLobe::kMaxExponent));
    put("MAX_WIDTH", number(DiffractionLobe::kMaxWidth));
    put("MAX_STRETCH", number(sparkle::kMaxStretch));
    put("PROJECTION_BLEND", number(sparkle::kProjectionBlend));
    put("FLAKE_LAYERS", flake_layers_text(layout));
    return text;
}

std::vector<WebglUniform> webgl_flake_uniforms(
    const std::vector<bsdf::NacreArrays::Species>& species) {
    WebglUniform field{
        "nacreField", 4, true, {}};  // side of the finest cells, mm; alpha; radius of
                                     // lobes times diameter, um; inverse cover
    WebglUniform levels{
        "nacreFieldLevels", 4, true, {}};  // full cells of coarse levels; typical lobe; widening; 0
    WebglUniform size{
        "nacreFieldSize", 4, true, {}};              // radii, mm; square of waviness; of all light
    WebglUniform key{"nacreFieldKey", 4, true, {}};  // of each level, 16 bits each from the lowest
    const auto add = [](WebglUniform& to, std::array<double, 4> values) {
        for (const double x : values) to.values.push_back(static_cast<float>(x));
    };
    for (const bsdf::NacreArrays::Species& s : species) {
        add(field, {s.field.cell_mm[0], s.alpha, s.radius_um, s.field.inverse_cover});
        add(levels, {s.field.full_cells.back(), s.field.typical_radius, s.field.max_widening, 0});
        const auto [smallest, largest] =
            std::minmax_element(s.diameter_um.begin(), s.diameter_um.end());
        add(size, {0.5e-3 * *smallest, 0.5e-3 * *largest, s.waviness * s.waviness, s.fraction});
        for (const std::uint64_t bits : s.field.key) {
            for (int part = 0; part < 4; ++part) {
                key.values.push_back(static_cast<float>(bits >> (16 * part) & 0xffffu));
            }
        }
    }
    const WebglUniform alike = webgl_films(bsdf::SpeciesFilms(species.size())).uniform;
    return {field, levels, size, key, alike};
}

WebglFilms webgl_films(const bsdf::SpeciesFilms& species) {
    constexpr int kRows = kWebglFilmIntervals + 1;
    WebglFilms out{{"nacreFilms", {1, 1}, {}}, {"nacreFieldFilms", 4, true, {}}};
    std::vector<const bsdf::FlakeFilms*> kinds;
    std::size_t max_sets = 0;
    for (const auto& films : species) {
        const std::size_t sets = films ? films->sets() : 0;
        std::size_t kind = 0;
        if (films) {
            // Sizes of one kind of flakes are species of their own.
            const auto same = std::find(kinds.begin(), kinds.end(), films.get());
            kind = static_cast<std::size_t>(same - kinds.begin());
            if (same == kinds.end()) kinds.push_back(films.get());
        }
        max_sets = std::max(max_sets, sets);
        const double min_cosine = films ? films->min_cosine() : 0;
        for (const double x : {static_cast<double>(sets), static_cast<double>(kRows * kind),
                               min_cosine, kWebglFilmIntervals / (1 - min_cosine)}) {
            out.uniform.values.push_back(static_cast<float>(x));
        }
    }
    std::vector<std::uint16_t>& rgba = out.texture.rgba;
    if (kinds.empty()) {
        rgba.assign(4, half_bits(1));
        return out;
    }
    const std::size_t width = 4 * max_sets;
    if (kRows * kinds.size() > kMaxTextureSize) {
        throw DomainError(fmt::format(
            "paint: its {} kinds of flakes with films that vary need a texture {} high; "
            "must be at most {}",
            kinds.size(), kRows * kinds.size(), kMaxTextureSize));
    }
    out.texture.size = {static_cast<int>(width), static_cast<int>(kRows * kinds.size())};
    rgba.assign(4 * width * kRows * kinds.size(), half_bits(1));
    std::uint16_t* to = rgba.data();
    for (const auto* kind : kinds) {
        constexpr std::size_t kStride = kWebglBands + 1;  // the last band is stored twice
        parallel_for(std::size_t{0}, std::size_t{kRows}, [&](std::size_t row) {
            for (std::size_t set = 0; set < kind->sets(); ++set) {
                const float* from = kind->ratios().data() + (set * kRows + row) * kStride;
                for (std::size_t b = 0; b < kWebglBands; ++b) {
                    to[4 * width * row + kWebglBands * set + b] = checked_half(from[b]);
                }
            }
        });
        to += 4 * width * kRows;
    }
    return out;
}

WebglTexture webgl_lobe_shapes() {
    const auto blur = DiffractionLobe::log_blur_table();
    const auto inverse = DiffractionLobe::inverse_lobe_fraction_table();
    WebglTexture out{
        "nacreLobeShapes", {DiffractionLobe::kSquareNodes, DiffractionLobe::kWidthNodes}, {}};
    for (std::size_t i = 0; i < blur.size(); ++i) {
        out.rgba.push_back(half_bits(blur[i]));
        // A logarithm, as it grows beyond half floats.
        out.rgba.push_back(half_bits(std::log(inverse[i])));
        out.rgba.insert(out.rgba.end(), {0, 0});
    }
    return out;
}

}  // namespace nacre::exchange
