#pragma once

#include <cstddef>
#include <optional>

#include "nacre/core/range.h"
#include "nacre/layers/recipe.h"
#include "nacre/optics/airy_range.h"

// What a recipe may say. validate() and the reader of recipe files (io/recipe_file.h) share these
// bounds; docs/recipe.md lists them. They are wide: they keep out slips of a decimal point and
// numbers on which arithmetic would fail, not unusual paints.

namespace nacre::layers::limits {

inline constexpr std::size_t kLayers = 64;
inline constexpr std::size_t kSpeciesPerLayer = 64;  ///< of flakes, and as many pigments
inline constexpr std::size_t kCoats = 64;
inline constexpr std::size_t kSpectrumSamples = 10'000;
inline constexpr std::size_t kNameLength = 200;

inline constexpr Range kWavelength{1, 1e6, "nm"};
inline constexpr Range kBinderIndex{1, 3};
inline constexpr Range kLayerThickness{0, 1e6, "um", true};
inline constexpr Range kClearcoatThickness{0, 1e6, "um"};
inline constexpr Range kPerMillimetre{0, 1e9, "1/mm"};
inline constexpr Range kRoughness{0, 1};
/// Roughness of an interface that is not smooth: a lobe below this is a mirror to every use there
/// is, and smooth interfaces are solved faster and to more digits.
inline constexpr Range kRoughInterface{0.01, 1};
inline constexpr Range kFraction{0, 1};  ///< reflectances and transmittances
inline constexpr Range kVolumeFraction{0, 1, "", true};
inline constexpr Range kAreaDensity{0, 1e6, "1/um", true};
inline constexpr Range kDiameter{0, 1e4, "um", true};
inline constexpr Range kDiameterSpread{0, 1e4, "um"};
inline constexpr Range kBeckmannAlpha{0.005, 1};
inline constexpr Range kPlateletThickness{0, 1e3, "um", true};
inline constexpr Range kFilmThickness{0, 1e5, "nm", true};
inline constexpr Range kFilmSpread{0, 1e5, "nm"};
inline constexpr Range kAnisotropy{-1, 1, "", true, true};

/// Below the least alpha a direction in single precision cannot tell slopes apart.
inline constexpr Range kMicrofacetAlpha{0.001, 1};
inline constexpr Range kMicrofacetIndex = optics::kAiryIndexRange;
inline constexpr Range kMicrofacetExtinction = optics::kAiryExtinctionRange;
inline constexpr Range kMicrofacetFilmThickness{0, 1e5, "nm"};
inline constexpr Range kFacetCount{1, 1e15};
inline constexpr Range kConeHalfAngle{0.05, 30, "deg"};

/// R + T may pass 1 by this much: what rounding leaves when both come from one computation.
inline constexpr double kEnergySlack = 1e-9;

/// The first wavelength (nm) at which R + T > 1, if there is one. Both spectra are linear between
/// their samples, so it is enough to look there.
std::optional<double> wavelength_of_excess(const PrescribedFlake& flake);

}  // namespace nacre::layers::limits
