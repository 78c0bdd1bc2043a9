#include "nacre/sparkle/coat_waves.h"

#include <cmath>
#include <numbers>

#include "nacre/core/lane_math.h"

namespace nacre::sparkle {
CoatWaves::CoatWaves(const paint::OrangePeel& peel, std::uint64_t seed) {
    for (std::size_t band = 0; band < paint::kWaveBands.size(); ++band) {
        const double slope = peel.*paint::kWaveBands[band].slope;
        if (slope == 0) continue;
        const auto& [shortest_mm, longest_mm] = paint::kWaveBands[band].wavelength_mm;
        // Of its own: the waves of one band do not depend on whether there are others.
        Rng rng(seed, hash_of(0x6f72616e6765ULL, band));
        // N A^2 / 2 is the mean square of the gradient, a third of it along any line.
        const double amplitude = slope * std::sqrt(2.0 * kWaveAxes / kWavesPerBand);
        const auto waves = plane_waves(shortest_mm, longest_mm, rng);
        for (int wave = 0; wave < kWavesPerBand; ++wave) {
            const int lane = wave % kLanes;
            if (lane == 0) groups_.emplace_back();
            groups_.back().waves.set(lane, waves[wave]);
            for (int i = 0; i < kWaveAxes; ++i) {
                groups_.back().slope[i][lane] =
                    static_cast<float>(amplitude * waves[wave].direction[i]);
            }
        }
    }
}

template <class Act>
void CoatWaves::for_each(Vec3f position_mm, const Act& act) const {
    const Vec3d x = to_double(position_mm);
    for (const Group& group : groups_) act(group, group.waves.turns_at(x));
}

Vec3d CoatWaves::gradient(Vec3f position_mm) const {
    FloatLanes sum[kWaveAxes]{};
    for_each(position_mm, [&](const Group& group, const DoubleLanes& turns) {
        const auto wave = cos_sin_turns(__builtin_convertvector(turns, FloatLanes));
        for (int i = 0; i < kWaveAxes; ++i) sum[i] -= group.slope[i] * wave.sine;
    });
    return to_double({lane_sum(sum[0]), lane_sum(sum[1]), lane_sum(sum[2])});
}

double CoatWaves::height_mm(Vec3f position_mm) const {
    double sum = 0;
    for_each(position_mm, [&](const Group& group, const DoubleLanes& turns) {
        const auto wave = cos_sin_turns(turns);
        for (int lane = 0; lane < kLanes; ++lane) {
            double slope2 = 0, product = 0;
            for (int i = 0; i < kWaveAxes; ++i) {
                slope2 += double{group.slope[i][lane]} * group.slope[i][lane];
                product += group.slope[i][lane] * group.waves.per_mm[i][lane];
            }
            // A^2 / (A / lambda): the amplitude A lambda / (2 pi) is that over 2 pi.
            sum += slope2 / product * wave.cosine[lane];
        }
    });
    return sum / (2 * std::numbers::pi);
}

Vec2f CoatWaves::slope(Vec3f position_mm, Vec3f normal, Vec3f tangent) const {
    const Vec3f along = to_float(gradient(position_mm));
    return {dot(along, tangent), dot(along, cross(normal, tangent))};
}

}  // namespace nacre::sparkle
