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
/// Relative to the mean over all patches, a patch shows `background` and flake by flake `weight`:
/// all of them add up to 1 in expectation. If the patch holds so many flakes that each of those
/// told apart stands for several, their lobes are wider by `widening`, so that as many answer as of
/// all flakes, each as bright as one of them: the fluctuation has the variance and nearly the law
/// of that of all flakes.                                              [docs/nacre-model.md,
/// levels]
struct FlakeView {
    /// The patch shows 30 flakes at most on average; a Poisson number of that mean is never larger.
    static constexpr int kMost = 128;

    int count = 0;
    float background =
        1;  ///< at the slope alpha of the half vector; for_each_answer() has the rest
    float weight_sum = 0;
    float widening = 1;
    float typical_radius = 0;  ///< lobe_radius of a flake of the mean diameter, over alpha
    // By flake, and a vector more: up to a whole vector there are flakes of radius 0.
    template <class T>
    using List = std::array<T, kMost + kLanes>;
    alignas(64) List<float> weight;
    alignas(64) List<float> slope_x, slope_y;     ///< of its normal, in the local frame
    alignas(64) List<float> lobe_radius;          ///< DiffractionLobe::radius() times widening
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
    /// halfway between (inside the coat), and returns the background for this h: over all patches
    /// it and the shares add up to 1 on average, for every h.
    ///
    /// @param slope     (h_x / h_z, h_y / h_z)
    /// @param cosine    w_i . h
    /// @param law       of the population
    template <class Visit>
    float for_each_answer(const DiffractionLobe& law, Vec2f slope, float cosine,
                          Visit&& visit) const;

    /// What answers is weighed by this, so that its variance is that of all flakes. The integral of
    /// K^2 P / (P * K)^2 goes with w^-2 (1 - (p^2/alpha^2 - 1) w^2/alpha^2 / 3 + ...): wider lobes
    /// lose more of it than the square of their width where P bends upwards, and less in its
    /// middle.
    float variance_correction(float exponent, float scale) const {
        if (widening == 1) return 1;
        const float radius = typical_radius * scale;
        const float bend = (exponent - 1) * radius * radius * (1.0f / 3);
        const float most = background < 1 ? 1 / (1 - background) : 1;
        return std::min(most, std::sqrt(std::max(1 - bend, 0.25f) /
                                        std::max(1 - widening * widening * bend, 0.25f)));
    }

    /// Picks a flake by weight and a slope of the half vector near its own; u in [0, 1).
    /// Requires weight_sum > 0.
    Vec2f sample_slope(const DiffractionLobe& law, Vec3f wi, float u_flake, Vec2f u) const;
    /// The density, per unit square of slopes, with which sample_slope() draws the slope.
    float slope_pdf(const DiffractionLobe& law, Vec3f wi, Vec2f slope) const;
};

}  // namespace nacre::sparkle

#include "nacre/sparkle/flake_view_inl.h"  // IWYU pragma: export
