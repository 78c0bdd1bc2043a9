#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "nacre/bsdf/microfacet_coat.h"

namespace nacre::bsdf {

/// What microfacets, seen through their coat, reflect of light from a direction: the mean of the
/// weights of their own samples, tabulated over the cosine of incidence, and how often to sample
/// the coat's mirror beside them.
class MicrofacetAlbedo {
 public:
    /// Fills the table. weight(wi, u) is the weight f cos / pdf, without the mirror, of the sample
    /// that the numbers u in (0, 1)^4 give for the direction wi; they are points of a Hammersley
    /// set.
    template <class Weight>
    void tabulate(Weight&& weight) {
        constexpr unsigned kPoints = 256;
        for (int row = 0; row <= kIntervals; ++row) {
            const float z = std::max(static_cast<float>(row) / kIntervals, 1e-3f);
            const Vec3f wi = {std::sqrt(1 - z * z), 0, z};
            FloatLanes sum{};
            for (unsigned p = 0; p < kPoints; ++p) {
                sum += weight(wi, std::array{(static_cast<float>(p) + 0.5f) / kPoints,
                                             radical_inverse(p, 2) + 0.5f / kPoints,
                                             radical_inverse(p, 3), radical_inverse(p, 5)});
            }
            lanes_[row] = sum * (1.0f / kPoints);
            means_[row] = lane_mean(lanes_[row]);
        }
    }

    /// Linear between rows; without the mirror.
    FloatLanes at(float cosine) const { return interpolate(lanes_, cosine); }

    /// Probability with which to sample the coat's mirror for a ray: in proportion to what mirror
    /// and facets reflect; 0 without a coat.
    float mirror_odds(const MicrofacetCoat& coat, const MicrofacetCoat::Ray& i) const {
        if (!coat.present()) return 0;
        const float mirror = coat.mirror_reflectance(i);
        if (!(mirror > 0)) return 0;
        constexpr float kLeast = 0.05f;  // either lobe, so that its weights stay bounded
        const float facets = interpolate(means_, i.outside.z);
        return std::clamp(mirror / (mirror + facets), kLeast, 1 - kLeast);
    }

 private:
    static constexpr int kIntervals = 16;

    template <class T>
    static T interpolate(const std::array<T, kIntervals + 1>& rows, float cosine) {
        const float x = std::min(cosine, 1.0f) * kIntervals;
        const int row = std::min(static_cast<int>(x), kIntervals - 1);
        return rows[row] + (x - static_cast<float>(row)) * (rows[row + 1] - rows[row]);
    }

    // The digits of p mirrored at the point.                    [niederreiter-1992, chapter 3]
    static float radical_inverse(unsigned p, unsigned base) {
        float value = 0, digit = 1;
        for (; p > 0; p /= base) {
            digit /= static_cast<float>(base);
            value += digit * static_cast<float>(p % base);
        }
        return value;
    }

    std::array<FloatLanes, kIntervals + 1> lanes_{};
    std::array<float, kIntervals + 1> means_{};
};

}  // namespace nacre::bsdf
