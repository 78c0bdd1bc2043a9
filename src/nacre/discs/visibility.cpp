#include "nacre/discs/visibility.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/core/parallel.h"
#include "nacre/core/rng.h"

namespace nacre::discs {
namespace {

/// Whether nothing stands between a point on a disc and the top, z = 0.
bool is_free(const DiscScene& scene, Vec3f point, Vec3f towards, std::uint32_t disc) {
    const Tile& tile = scene.tile();
    double x = point.x, y = point.y, z = point.z;
    tile.wrap(x, y);
    for (;;) {
        const double top = std::max(0.0, -z / towards.z);
        const double edge = tile.to_edge(x, y, towards.x, towards.y);
        const double far = std::min(top, edge);
        const Vec3f from{static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
        if (scene.intersect(from, towards, static_cast<float>(far), disc)) return false;
        if (top <= edge) return true;
        x += far * towards.x;
        y += far * towards.y;
        z += far * towards.z;
        tile.step_over(x, y, towards.x, towards.y);
        disc = DiscScene::kNone;
    }
}

struct Sums {
    double lit = 0, both = 0, product = 0, square = 0;
};

}  // namespace

Visibility flake_visibility(const DiscScene& scene, Vec3f towards_light, Vec3f towards_eye,
                            std::uint64_t seed) {
    constexpr std::size_t kBlock = 4096;
    const std::size_t count = scene.count(), blocks = (count + kBlock - 1) / kBlock;
    std::vector<Sums> sums(blocks);
    parallel_for(0, blocks, [&](std::size_t b) {
        Rng rng(seed, b);
        for (std::size_t i = b * kBlock; i < std::min(count, (b + 1) * kBlock); ++i) {
            const auto number = static_cast<std::uint32_t>(i);
            const Disc& disc = scene[number];
            const Frame frame = Frame::around(disc.normal);
            double v[2];
            for (double& visible : v) {
                const float r = disc.radius_um * std::sqrt(rng.uniform_float());
                const float phi = 2 * std::numbers::pi_v<float> * rng.uniform_float();
                const Vec3f point =
                    disc.centre_um + r * std::cos(phi) * frame.s + r * std::sin(phi) * frame.t;
                const bool lit = is_free(scene, point, towards_light, number);
                visible = lit && is_free(scene, point, towards_eye, number);
                sums[b].lit += 0.5 * lit;
            }
            sums[b].both += 0.5 * (v[0] + v[1]);
            sums[b].square += 0.25 * (v[0] + v[1]) * (v[0] + v[1]);
            sums[b].product += v[0] * v[1];
        }
    });
    Sums total;
    for (const Sums& s : sums) {
        total.lit += s.lit;
        total.both += s.both;
        total.product += s.product;
        total.square += s.square;
    }
    const double n = static_cast<double>(count), mean = total.both / n;
    return {total.lit / n, mean, total.product / n,
            std::sqrt(std::max(0.0, total.square / n - mean * mean) / n)};
}

}  // namespace nacre::discs
