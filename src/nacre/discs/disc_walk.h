#pragma once

#include <memory>
#include <vector>

#include "nacre/bsdf/bsdf.h"
#include "nacre/discs/disc.h"
#include "nacre/layers/solver.h"

// The explicit ground truth of sparkle: paint with every flake in its place.
// docs/explicit-flakes.md

namespace nacre::discs {

class DiscScene;
struct DiscWalkTables;

/// A tile's sides are at least this times the thickness of the paint.
inline constexpr double kLeastTileShare = 0.1;

struct DiscSettings {
    /// The piece of paint that repeats itself over the panel, in kTileSide. As large as the panel:
    /// nothing repeats, and only light that crosses the panel's edge within the paint comes back at
    /// the opposite one.
    double tile_width_mm = 10, tile_height_mm = 10;
    std::uint64_t seed = 0;  ///< which flakes there are
    /// Whether a flake spreads what it mirrors by the Airy pattern of its disc (airy_disc.h) at the
    /// mean of the eight wavelengths; if not, it is a perfect mirror.
    bool diffraction = true;
};

/// A flat panel of paint whose flakes are discs, and whose light is followed from disc to disc:
/// geometry instead of the equation of transfer. Flakes hide each other one by one, light finds its
/// way out where it found its way in, and what is seen of a flake moves with its depth.
///
/// Patches are read in rest space (Layout::rest_space): the panel's plane must be one of z = const,
/// and x and y tell the place. Without a patch the place is random: the mean over the panel. Only
/// sample() and sample_on() tell what the paint looks like, as with volume::PlaneWalk: eval() and
/// pdf() are zero, and a renderer sees no light source without extent.
///
/// Supports all that a recipe may say. What a flake reflects and lets pass is that of its own films
/// (flake_films.h); pigments scatter between the flakes; the interface may be rough.
class DiscWalk final : public bsdf::Bsdf {
 public:
    /// @param wavelengths_nm  as for volume::PlaneWalk
    /// @throws DomainError if the recipe is not valid at these wavelengths, naming a setting out of
    ///         range, or as draw_discs()
    DiscWalk(const layers::Recipe& recipe, const DiscSettings& settings,
             const std::vector<double>& wavelengths_nm = layers::default_wavelengths_nm());
    ~DiscWalk() override;

    std::unique_ptr<const bsdf::BoundBsdf> bind(
        const bsdf::Wavelengths& wavelengths_nm) const override;
    bsdf::Layout layout() const override { return bsdf::Layout::rest_space; }

    const DiscScene& scene() const;

 private:
    std::shared_ptr<const DiscWalkTables> tables_;
};

}  // namespace nacre::discs
