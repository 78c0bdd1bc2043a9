#pragma once

#include <array>
#include <cstdint>

#include "nacre/core/lanes.h"
#include "nacre/core/rng.h"
#include "nacre/core/vec.h"
#include "nacre/sparkle/diffraction_lobe.h"

namespace nacre::sparkle {

/// The flakes of one population that a patch shows: found once, asked for every pair of directions.
///
/// Relative to the mean over all patches, a patch shows `background`, the same for every direction,
/// and flake by flake `weight`: background and all weights add up to 1 in expectation, and the
/// fluctuation of their sum is that of the flakes that lie in the patch, however many they are and
/// however many of them are told apart here.                  [docs/nacre-model.md, levels]
struct FlakeView {
    /// The patch shows 30 flakes at most on average; a Poisson number of that mean is never larger.
    static constexpr int kMost = 128;

    int count = 0;
    float background = 1;
    float weight_sum = 0;
    // By flake, and a vector more: up to a whole vector there are flakes of radius 0.
    template <class T>
    using List = std::array<T, kMost + kLanes>;
    alignas(64) List<float> weight;
    alignas(64) List<float> slope_x, slope_y;     ///< of its normal, in the local frame
    alignas(64) List<float> lobe_radius;          ///< DiffractionLobe::radius()
    alignas(64) List<std::uint32_t> place, kind;  ///< all else of it is a hash of these

    /// Where it lies in its layer, 0 at the top and 1 at the bottom, evenly; and 32 bits for which
    /// of the population's films it has.
    struct Body {
        float depth;
        std::uint32_t film;
    };
    Body body(int flake) const {
        const std::uint64_t b = hash_of(place[flake], kind[flake]);
        return {to_unit_float(static_cast<std::uint32_t>(b)), static_cast<std::uint32_t>(b >> 32)};
    }

    /// Calls visit(flake, share) for the flakes that mirror one direction into another, h being
    /// halfway between (inside the coat): over all patches the shares add up to 1 - background on
    /// average, for every h.
    ///
    /// @param slope     (h_x / h_z, h_y / h_z)
    /// @param cosine    w_i . h
    /// @param law       of the population
    template <class Visit>
    void for_each_answer(const DiffractionLobe& law, Vec2f slope, float cosine,
                         Visit&& visit) const;

    /// Picks a flake by weight and a slope of the half vector near its own; u in [0, 1).
    /// Requires weight_sum > 0.
    Vec2f sample_slope(const DiffractionLobe& law, Vec3f wi, float u_flake, Vec2f u) const;
    /// The density, per unit square of slopes, with which sample_slope() draws the slope.
    float slope_pdf(const DiffractionLobe& law, Vec3f wi, Vec2f slope) const;
};

}  // namespace nacre::sparkle

#include "nacre/sparkle/flake_view_inl.h"  // IWYU pragma: export
