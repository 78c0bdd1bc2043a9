#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "nacre/bsdf/models/nacre_arrays.h"
#include "nacre/core/progress.h"
#include "nacre/core/vec.h"
#include "nacre/solver/solved_paint.h"

// A paint as a shader of WebGL 2: the mean of the model nacre from the arrays that Nacre hands to
// other renderers (bsdf/models/nacre_arrays.h), single scattering in closed form at sixteen
// wavelengths, with the hot spot of large flakes, and multiple scattering from a texture of three
// dimensions in RGB.
//
// The text depends on the paint's structure alone: how many layers, flakes and pigments it has, and
// whether its coat is rough. All that a slider changes is in uniforms and textures, so that a
// program is compiled once and then handed numbers. `program` tells whether it is the same one.

namespace nacre::exchange {

/// A uniform of the shader: float, vec2 or vec4, or an array of them.
struct WebglUniform {
    std::string name;
    int components = 1;  ///< 1, 2 or 4
    bool array = false;
    std::vector<float> values;  ///< components of all elements, one after the other
};

/// A texture in RGBA of half floats, the first row or layer first.
struct WebglTexture {
    std::string name;                 ///< of its sampler
    std::vector<int> size;            ///< width, height and, of three dimensions, depth
    std::vector<std::uint16_t> rgba;  ///< bits of half floats
};

/// What nacreColour(wi, wo) and the other functions of webgl_shader.glsl need.
struct WebglShader {
    std::string program;  ///< SHA-256 of `glsl`
    /// GLSL ES 3.00 that declares the uniforms; whoever includes it defines PI and the precision of
    /// floats.
    std::string glsl;
    std::vector<WebglUniform> uniforms;
    std::vector<WebglTexture> textures;
    bool smooth_coat = true;  ///< its mirror image is not in nacreBrdf(): that is nacreFresnel()

    /// The same text with the numbers in it, for a file that holds one paint.
    std::string glsl_with_constants() const;

    /// What nacreColour() gives, by the same arithmetic from the same textures: in 1/sr, linear
    /// Rec. 709, without the mirror image in a smooth coat. Directions are unit vectors away from
    /// the surface, above it.
    Vec3d brdf(Vec3d wi, Vec3d wo) const;

    /// How the channels of the table are laid out.
    struct Layout;
    std::shared_ptr<const Layout> layout;
};

/// Bands of wavelengths: four texels of four.
inline constexpr int kWebglBands = 16;
/// Rows of the table: functions of a place from 0 to 1.
inline constexpr int kWebglRows = 257;

/// @param lamp  of all lights of the scene: colours are those that an eye sees that has adapted to it,
///              and the lights are to be white
/// @throws DomainError if there are fewer than two wavelengths, a value is beyond half floats, or the
///         paint has so many species that no texture holds them
WebglShader make_webgl_shader(const bsdf::NacreArrays& arrays,
                              spectra::Illuminant lamp = spectra::Illuminant::D65);

/// The same for a picture that follows a slider: of a solved paint, by bsdf::nacre_live_arrays(), and
/// hence without nacreAlbedo(); with the flakes of a specimen, where there are any (webgl_flakes.glsl).
/// Flakes of a species are alike until they are given make_live_webgl_films().
/// @param lamp  as above
/// @throws DomainError as above; Error as bsdf::HotSpotTables
WebglShader make_live_webgl_shader(const std::shared_ptr<const solver::SolvedPaint>& paint,
                                   std::uint64_t specimen = 0,
                                   spectra::Illuminant lamp = spectra::Illuminant::D65);

/// FlakeFilms, of each kind of flakes once: sets of flakes to the right, each with four texels of its
/// bands, cosines downwards. And where a species finds its own: how many sets, 0 if all its flakes are
/// alike, the first row, the least cosine, and rows per cosine.
struct WebglFilms {
    WebglTexture texture;  ///< nacreFilms
    WebglUniform uniform;  ///< nacreFieldFilms, in the place of that of the shader
};
/// What tells single flakes of make_live_webgl_shader() apart. The mean does not need it; where a film has
/// changed it takes nearly half as long as all else.
/// @throws DomainError, Stopped as bsdf::FlakeFilms; DomainError if no texture is high enough
WebglFilms make_live_webgl_films(const solver::SolvedPaint& paint, const Progress& progress = {});

}  // namespace nacre::exchange
