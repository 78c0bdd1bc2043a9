#include <numbers>

#include "nacre/sparkle/facet_field.h"
#include "nacre/sparkle/lane_bits.h"

// Small footprints: facet by facet.

namespace nacre::sparkle {
// Bounds on a facet's raw bits that every normal in a cone keeps: a ring and a sector of slopes
// about the half vector. What they let through is tested exactly.
struct FacetField::NormalFilter {
    std::uint32_t survival_lo = 0, survival_range = 0;    // upper half: exp(-tan^2 / alpha^2)
    std::uint32_t turn_lo = 0, turn_range = 0xffffffffu;  // lower half: azimuth, wraps around
    bool empty = true;

    NormalFilter(const ReflectionCone& cone, double alpha) {
        // The bisector of wi and a direction at a chord c from wo is turned against that of wi and
        // wo by an angle of sine at most c / |wi + wo|.
        const Vec3f h = cone.wi + cone.wo;
        const double length2 = dot(h, h);
        const double sine_reach2 = cone.chord2 / length2 * 1.0001 + 1e-12;
        double sine_lo = 0, sine_hi = 1;
        if (h.z > 0 && sine_reach2 < 1) {
            const double sine_reach = std::sqrt(sine_reach2);
            const double cosine_reach = std::sqrt(1 - sine_reach2);
            const double sine2 = (static_cast<double>(h.x) * h.x + h.y * h.y) / length2;
            const double sine = std::sqrt(sine2), cosine = h.z / std::sqrt(length2);
            if (cosine > sine_reach) sine_hi = sine * cosine_reach + cosine * sine_reach;
            if (sine > sine_reach) {
                sine_lo = sine * cosine_reach - cosine * sine_reach;
                const double reach_turns = std::asin(sine_reach / sine) / (2 * std::numbers::pi);
                const double turn = std::atan2(h.y, h.x) / (2 * std::numbers::pi);
                const double lo = (turn - reach_turns) - std::floor(turn - reach_turns);
                turn_lo = static_cast<std::uint32_t>(lo * 0x1p32 - 0.5 * lo) - 64;
                turn_range = static_cast<std::uint32_t>(2 * reach_turns * 0x1p32) + 1024;
            }
        }
        const auto survival = [&](double s) {
            const double s2 = std::min(s * s, 1.0);
            return std::exp(-s2 / std::max(1 - s2, 1e-30) / (alpha * alpha)) * 0x1p32;
        };
        const double lo = std::floor(survival(sine_hi) * 0.9999) - 2;
        const double hi = std::ceil(survival(sine_lo) * 1.0001) + 2;
        empty = hi < 3;
        survival_lo = static_cast<std::uint32_t>(std::max(0.0, lo));
        survival_range = static_cast<std::uint32_t>(std::min(hi, 0x1p32 - 1)) - survival_lo;
    }
};

// Facets that passed the filter, tested eight at a time.
struct FacetField::Candidates {
    const ReflectionCone& cone;
    float alpha;
    FacetTally& tally;
    std::array<std::uint64_t, kLanes> bits;
    int count = 0;

    void add(std::uint64_t normal_bits) {
        bits[count++] = normal_bits;
        if (count == kLanes) test();
    }
    void test() {
        BitLanes normals{};
        for (int i = 0; i < count; ++i) normals[i] = bits[i];
        const SlopeLanes slopes = gaussian_slopes(normals);
        const auto in = cone.contains(alpha * slopes.x, alpha * slopes.y, splat(1.0f));
        for (int i = 0; i < count; ++i) {
            if (in[i]) tally.add(thickness_of(bits[i]));
        }
        count = 0;
    }
};

void FacetField::count_facets(const Footprint& footprint, const ReflectionCone& cone,
                              FacetTally& tally) const {
    const NormalFilter filter(cone, alpha_);
    if (filter.empty) return;
    Candidates candidates{cone, alpha_f_, tally, {}};
    for_each_cell(footprint, leaf_level_,
                  [&](const Cell& cell) { count_leaf(footprint, cell, filter, candidates); });
    candidates.test();
}

// Looks at eight facets at a time.
void FacetField::count_leaf(const Footprint& footprint, const Cell& cell,
                            const NormalFilter& filter, Candidates& candidates) const {
    constexpr std::uint64_t kLow = 0xffffffffu;
    constexpr BitLanes kNumber = {0, 1, 2, 3, 4, 5, 6, 7};
    const std::uint64_t key = key_of(cell);
    const Footprint::Within within = footprint.within(cell.box());
    for (std::uint64_t first = 0; first < cell.count; first += kLanes) {
        const BitLanes number = first + kNumber;
        const BitLanes place = mix_lanes(key + (number + 4) * detail::kNextBits);
        const BitLanes bits = mix_lanes(place + detail::kNextBits);
        auto pass = (number < cell.count) &
                    ((bits >> 32) - filter.survival_lo <= std::uint64_t{filter.survival_range}) &
                    ((((bits & kLow) - filter.turn_lo) & kLow) <= std::uint64_t{filter.turn_range});
        if (!cell.inside) {
            const DoubleLanes u = __builtin_convertvector(place >> 32, DoubleLanes) * 0x1p-32;
            const DoubleLanes v = __builtin_convertvector(place & kLow, DoubleLanes) * 0x1p-32;
            pass &= within.contains(u, v);
        }
        for_each_set_lane(pass, [&](int lane) { candidates.add(bits[lane]); });
    }
}

}  // namespace nacre::sparkle
