#include "nacre/sparkle/coat_waves.h"

#include <cmath>
#include <numbers>

#include "nacre/core/lane_math.h"
#include "nacre/core/random.h"

namespace nacre::sparkle {
namespace {

constexpr int kAxes = 3;
static_assert(CoatWaves::kWavesPerBand % kLanes == 0 && CoatWaves::kWavesPerBand % kAxes == 0);

/// Three unit vectors at right angles, all rotations equally likely: by a unit quaternion.
/// [shoemake-1992]
std::array<Vec3d, kAxes> random_axes(Rng& rng) {
    const double u = rng.uniform_double();
    const double a = 2 * std::numbers::pi * rng.uniform_double();
    const double b = 2 * std::numbers::pi * rng.uniform_double();
    const double x = std::sqrt(1 - u) * std::sin(a), y = std::sqrt(1 - u) * std::cos(a);
    const double z = std::sqrt(u) * std::sin(b), w = std::sqrt(u) * std::cos(b);
    return {Vec3d{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
            Vec3d{2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
            Vec3d{2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)}};
}

}  // namespace

CoatWaves::CoatWaves(const paint::OrangePeel& peel, std::uint64_t seed) {
    for (std::size_t band = 0; band < paint::kWaveBands.size(); ++band) {
        const double slope = peel.*paint::kWaveBands[band].slope;
        if (slope == 0) continue;
        const auto& [shortest_mm, longest_mm] = paint::kWaveBands[band].wavelength_mm;
        // Of its own: the waves of one band do not depend on whether there are others.
        Rng rng(seed, hash_of(0x6f72616e6765ULL, band));
        // N A^2 / 2 is the mean square of the gradient, a third of it along any line.
        const double amplitude = slope * std::sqrt(2.0 * kAxes / kWavesPerBand);
        std::array<Vec3d, kAxes> axes;
        for (int wave = 0; wave < kWavesPerBand; ++wave) {
            if (wave % kAxes == 0) axes = random_axes(rng);
            if (wave % kLanes == 0) groups_.emplace_back();
            const double octave = (wave + rng.uniform_double()) / kWavesPerBand;
            const double wavelength_mm = shortest_mm * std::pow(longest_mm / shortest_mm, octave);
            const Vec3d& k = axes[wave % kAxes];
            Group& group = groups_.back();
            const int lane = wave % kLanes;
            for (int i = 0; i < kAxes; ++i) {
                group.per_mm[i][lane] = k[i] / wavelength_mm;
                group.slope[i][lane] = static_cast<float>(amplitude * k[i]);
            }
            group.phase[lane] = rng.uniform_double();
        }
    }
}

template <class Act>
void CoatWaves::for_each(Vec3f position_mm, const Act& act) const {
    const Vec3d x = to_double(position_mm);
    for (const Group& group : groups_) {
        // Whole turns are many, and leave before the digits do.
        const DoubleLanes turns =
            group.per_mm[0] * x.x + group.per_mm[1] * x.y + group.per_mm[2] * x.z + group.phase;
        const DoubleLanes left = turns - detail::nearest_integer<DoubleLanes>(turns).value;
        act(group, left);
    }
}

Vec3d CoatWaves::gradient(Vec3f position_mm) const {
    FloatLanes sum[kAxes]{};
    for_each(position_mm, [&](const Group& group, const DoubleLanes& turns) {
        const auto wave = cos_sin_turns(__builtin_convertvector(turns, FloatLanes));
        for (int i = 0; i < kAxes; ++i) sum[i] -= group.slope[i] * wave.sine;
    });
    return to_double({lane_sum(sum[0]), lane_sum(sum[1]), lane_sum(sum[2])});
}

double CoatWaves::height_mm(Vec3f position_mm) const {
    double sum = 0;
    for_each(position_mm, [&](const Group& group, const DoubleLanes& turns) {
        const auto wave = cos_sin_turns(turns);
        for (int lane = 0; lane < kLanes; ++lane) {
            double slope2 = 0, product = 0;
            for (int i = 0; i < kAxes; ++i) {
                slope2 += double{group.slope[i][lane]} * group.slope[i][lane];
                product += group.slope[i][lane] * group.per_mm[i][lane];
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
