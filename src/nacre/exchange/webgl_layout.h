#pragma once

#include <fmt/format.h>

#include <iterator>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "nacre/exchange/webgl_shader.h"

// What the files of the shader share: internal to this folder.

namespace nacre::exchange {

using Bands = std::array<float, kWebglBands>;

/// Of a band among the wavelengths of a paint, for linear interpolation.
struct WebglBand {
    double nm;
    std::size_t low;
    double part;

    /// @param values  by wavelength
    template <class T>
    double of(const T* values) const {
        return values[low] * (1 - part) + values[low + 1] * part;
    }
};
/// Evenly from the first wavelength to the last. @throws DomainError if there are fewer than two
std::array<WebglBand, kWebglBands> webgl_bands(const std::vector<double>& wavelengths_nm);

/// @throws DomainError if no half float holds it
std::uint16_t checked_half(double value);

/// The widest texture of every WebGL 2 (MAX_TEXTURE_SIZE).
inline constexpr std::size_t kMaxTextureSize = 2048;

/// A channel is a function of a place in [0, 1] at all bands: four texels beside each other in every row
/// of the table.
struct WebglShader::Layout {
    struct Flake {
        int reflectance;  ///< channel by the cosine on the flake
        double scale;     ///< half the area per volume over 2 pi alpha^2, 1/um
        double alpha;
    };
    struct Pigment {
        double anisotropy;
        Bands scattering_per_um;
        std::optional<int> phase;  ///< channel by the angle; none: Henyey and Greenstein's
    };
    struct Layer {
        double thickness_um, top_um;
        int extinction;  ///< channel by tan(theta / 2), 1/um
        std::vector<Flake> flakes;
        std::vector<Pigment> pigments;
    };
    /// Of a species of flakes, through which light that came in finds its way out.
    struct Gaps {
        std::size_t layer;
        double diameter_um;
        int coupling;  ///< channel by tan(theta / 2)
    };
    double ior, roughness;
    Bands clearcoat_depth;
    std::array<Bands, 3> rgb;  ///< weights of the bands in red, green and blue
    std::vector<Layer> layers;
    std::vector<Gaps> gaps;
    std::optional<int> ground;        ///< light from below that met no flake
    std::optional<int> compensation;  ///< of the other multiple scattering, so that none is lost
    std::optional<int> albedo, masked, masking;
    struct Lobe {
        double alpha, ior;
        friend auto operator<=>(const Lobe&, const Lobe&) = default;
    };
    std::vector<Lobe> lobes;  ///< from which directions are drawn, at most kMaxLobes
    static constexpr int kMaxLobes = 5;
    /// Single flakes, by species; none are shown if empty.
    struct Species {
        sparkle::FlakeField::Constants field;
        std::size_t layer;
        int sizes;        ///< channel whose first number is the diameter, um, by row
        int reflectance;  ///< Flake::reflectance
    };
    std::vector<Species> species;
};

/// Over a layer's depth, densest at the top: u = s^2, du = 2 s ds of Gauss and Legendre's rule.
struct WebglNode {
    double place, weight;
};
std::vector<WebglNode> webgl_nodes();

/// Adds lines to a text, indented as where it will stand.
class WebglLines {
 public:
    template <class... Args>
    void add(fmt::format_string<Args...> format, Args&&... args) {
        if (!text_.empty()) text_ += "\n    ";
        text_ += fmt::format(format, std::forward<Args>(args)...);
    }
    /// Adds a line for each group of bands, whose number takes the place of `@`: processors that draw
    /// (SwiftShader) unroll no loop, and take a third longer where a variable says which element.
    void add_for_groups(std::string_view line);
    std::string text() && { return std::move(text_); }

 private:
    std::string text_;
};
/// Optical depths, beyond which 6e-6 of the light comes from.
inline constexpr double kFarthestDepth = 24;

/// What single flakes add: the text, with the uniforms of `layout`.
std::string webgl_flakes_glsl(const WebglShader::Layout& layout);
/// Uniforms, by which flakes of one species are alike (nacreFieldFilms), and the texture of the lobes' shapes.
std::vector<WebglUniform> webgl_flake_uniforms(
    const std::vector<bsdf::NacreArrays::Species>& species);
WebglTexture webgl_lobe_shapes();

/// Between the cosines of films: half as many as the path tracer has, at half as many wavelengths, so that
/// flakes wait for a quarter of the work when a film's slider moves.
inline constexpr int kWebglFilmIntervals = 32;
/// @param species  their films by bands and kWebglFilmIntervals
/// @throws DomainError if no texture is high enough
WebglFilms webgl_films(const bsdf::SpeciesFilms& species);

/// Declares share0, share1, ..., lengths by which the gaps of each species help light from the fraction
/// `u` of a layer's thickness, and returns ln of what they let through, for add_for_groups().
std::string webgl_gain(const WebglShader::Layout& layout, std::size_t layer, const char* u,
                       const char* indent, WebglLines& lines);
/// Declares gap0, gap1, ... of a pair p.
void webgl_gaps(const WebglShader::Layout& layout, WebglLines& lines);

/// A float of GLSL, which must not be an integer.
inline std::string glsl_number(double x) { return fmt::format("{:.8e}", x); }
/// Every occurrence, as of a placeholder in a text.
void replace_all(std::string& text, std::string_view from, std::string_view to);

/// The text, with `numbers` where the uniforms are declared.
std::string webgl_glsl(const WebglShader::Layout& layout, const std::string& numbers);

}  // namespace nacre::exchange
