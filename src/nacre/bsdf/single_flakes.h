#pragma once

namespace nacre::bsdf {

/// What surfaces have in common that show single flakes on small patches and, on larger ones, a few
/// flakes that stand for all.
class SingleFlakes {
 public:
    virtual ~SingleFlakes() = default;
    /// Side of the largest square patch of a flat panel on which every flake is told apart, so that
    /// nothing is approximated. 0 if flakes lie too densely for any patch; infinite without flakes.
    virtual double exact_patch_mm() const = 0;
};

}  // namespace nacre::bsdf
