#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "nacre/core/error.h"

// Drawdowns: films of paint of known thickness over a black and a white ground, as painters make
// them to see how a pigment hides and colours.

namespace nacre::measure {

/// How a drawdown was read, by the geometries of the CIE.                       [cie-15-2018]
enum class DrawdownGeometry {
    diffuse_8_included,  ///< an integrating sphere and 8 deg, the gloss included (di:8, SCI)
    diffuse_8_excluded,  ///< the same without the gloss (de:8, SCE)
    angle_45_0           ///< lamp at 45 deg, view along the normal
};

/// The reflectance of one application of the paint, or of a bare ground.
struct DrawdownReading {
    std::string ground;                ///< its name, such as "black"; of opaque paint perhaps empty
    double thickness_um = 0;           ///< of the dry paint; 0: the bare ground
    double volume_fraction = 0;        ///< of the pigment in the dry paint
    std::vector<double> reflectance;   ///< factor at each wavelength, 1 being the perfect diffuser
    double white_volume_fraction = 0;  ///< of a known white beside it: a tint
    bool opaque =
        false;  ///< so thick that nothing is seen of the ground; thickness_um says nothing

    bool is_bare() const { return !opaque && thickness_um == 0; }
};

struct Drawdown {
    std::vector<double> wavelengths_nm;
    std::vector<DrawdownReading> readings;
};

inline constexpr std::size_t kMaxDrawdownReadings = 1000;
inline constexpr Range kDrawdownReflectance{0, 1.2};
inline constexpr Range kDrawdownThickness{0, 1e5, "um"};

}  // namespace nacre::measure
