#pragma once

#include <cstdint>
#include <vector>

#include "nacre/core/range.h"
#include "nacre/sparkle/flake_sizes.h"
#include "nacre/sparkle/flake_view.h"
#include "nacre/sparkle/rest_patch.h"

namespace nacre::sparkle {

/// Flakes of one kind in one layer of a paint, as statistics.
struct FlakePopulation {
    double density_per_mm2 = 0;     ///< flakes per area of the surface: rho H = c H / mean area
    double diameter_um = 20;        ///< mean
    double diameter_spread_um = 0;  ///< standard deviation (flake_sizes.h)
    double alpha = 0.1;             ///< Beckmann roughness: slopes of variance alpha^2 / 2
    double ior = 1.5;               ///< of the binder, for diffraction
};

/// The flakes of one population on a shape: any number, none of them stored, and always the same.
///
/// A Poisson process over place, slope, size, depth and film. Each flake is a hash of the cell in
/// which it lies. Cells tile three planes, those of the axes of the shape's rest space, and a
/// patch looks through the surface at the plane that it faces; where it faces two or three about
/// equally, each gives a share of the flakes, so that there is neither seam nor stretch anywhere on
/// any shape (projection.h). Flakes are shared out among levels of density falling by 16: a patch
/// tells the flakes apart of those levels that have few on it, and takes the rest as their mean
/// (FlakeView). Cost is bounded for any patch and any density, and memory does not depend on
/// either.                                                            [docs/nacre-model.md]
class FlakeField {
 public:
    /// @throws DomainError naming the argument, its value and its range
    FlakeField(const FlakePopulation& population, std::uint64_t seed);

    /// Replaces `view` by what the patch shows.
    void look(const RestPatch& patch, FlakeView& view) const;

    const FlakePopulation& population() const { return population_; }
    const DiffractionLobe& lobe() const { return lobe_; }
    const FlakeSizes& sizes() const { return sizes_; }

 private:
    FlakePopulation population_;
    FlakeSizes sizes_;
    DiffractionLobe lobe_;
};

}  // namespace nacre::sparkle
