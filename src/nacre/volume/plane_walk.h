#pragma once

#include <memory>
#include <vector>

#include "nacre/bsdf/bsdf.h"
#include "nacre/layers/recipe.h"
#include "nacre/layers/solver.h"

// The Monte Carlo reference as a surface to render with. docs/volume.md

namespace nacre::volume {

struct WalkTables;

/// A paint whose light is followed flake by flake, by depth alone: the position-free walk of
/// reference/, for one packet of light at eight wavelengths.   [guo-hasan-zhao-2018; wilkie-2014]
///
/// Only sample() tells what the paint looks like: it sends light in from wi and follows it until it
/// leaves, always with mirror = true and pdf = 1, as nobody knows the density of what it found.
/// eval() and pdf() are zero. A renderer must not weigh it against light sampling, and sees no
/// light source without extent. The same (wi, u_lobe, u) gives the same walk.
///
/// Supports all that a recipe may say: pigments, several layers, a rough clearcoat. Where the
/// binder's index differs between the eight wavelengths, light bends differently, and each walk
/// carries one of them, drawn by lot: the mean is right, the noise coloured.
class PlaneWalk final : public bsdf::Bsdf {
 public:
    /// @param wavelengths_nm  where films are computed; between them, R, T and all else are linear
    ///                        in wavelength, beyond them constant
    /// @throws DomainError if the recipe is not valid at these wavelengths, or if its clearcoat's
    ///         roughness is above 0 and below reference::kLeastRoughness
    explicit PlaneWalk(const layers::Recipe& recipe, const std::vector<double>& wavelengths_nm =
                                                         layers::default_wavelengths_nm());
    ~PlaneWalk() override;

    std::unique_ptr<const bsdf::BoundBsdf> bind(
        const bsdf::Wavelengths& wavelengths_nm) const override;

 private:
    std::shared_ptr<const WalkTables> tables_;
};

}  // namespace nacre::volume
