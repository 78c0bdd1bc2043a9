#pragma once

#include <array>
#include <optional>
#include <vector>

#include "nacre/bsdf/smooth_table.h"
#include "nacre/bsdf/wavelength_lanes.h"
#include "nacre/core/progress.h"
#include "nacre/solver/solved_paint.h"

// What LeaningFlakes asks a paint whose flakes lie flat, beyond its light as a whole.

namespace nacre::bsdf {

struct LeaningTables {
    /// @throws as solver::solve_without_internal_reflection()
    LeaningTables(const solver::SolvedPaint& paint, SharedProgress& work);

    /// A solution and its table, on the grid of the paint's own.
    struct Part {
        explicit Part(solver::SolvedPaint solved);
        solver::SolvedPaint paint;
        SmoothTable table;
    };
    /// Without the ground; none where that reflects nothing.
    std::optional<Part> over_black;
    /// Without the ground: what left the coat when it first met the interface from inside.
    Part no_internal_reflection;

    /// OpticalDepths of even cosines from 0 to 1: [cosine][wavelength], and by wavelength.
    static constexpr int kCosineIntervals = 64;
    std::vector<float> flake_extinction, flake_scattering, pigment_extinction, pigment_absorption;

 private:
    void tabulate_depths(const solver::PaintMedium& medium);
};

/// The same at eight wavelengths.
class BoundLeaningTables {
 public:
    BoundLeaningTables(const LeaningTables& tables,
                       const std::array<WavelengthPosition, kLanes>& where);

    OpticalDepths depths(float cosine) const;

    BoundSmoothTable over_black;  ///< none where the ground reflects nothing
    BoundSmoothTable no_internal_reflection;

 private:
    std::vector<FloatLanes> flake_extinction_, flake_scattering_;  // by cosine
    FloatLanes pigment_extinction_, pigment_absorption_;
};

}  // namespace nacre::bsdf
