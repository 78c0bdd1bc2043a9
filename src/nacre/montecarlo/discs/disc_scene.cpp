#include "nacre/montecarlo/discs/disc_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "nacre/core/embree.h"
#include "nacre/core/error.h"
#include "nacre/core/parallel.h"
#include "nacre/core/random.h"

namespace nacre::montecarlo {
namespace {

/// Least distance from one disc to the next: where two discs cross, rounding can put the light in
/// front of either for ever. Hits nearer than this are missed, one in 1e5.
constexpr float kMinFlight_um = 1e-4f;

constexpr const char* kBuilding = "building the paint's flakes";

}  // namespace

DiscScene::DiscScene(std::vector<Disc> discs, const Tile& tile, SharedProgress* work)
    : tile_(tile),
      count_(discs.size()),
      discs_(std::move(discs)),
      device_(rtcNewDevice(nullptr), [](RTCDeviceTy* d) { rtcReleaseDevice(d); }),
      scene_(nullptr, [](RTCSceneTy* s) { rtcReleaseScene(s); }) {
    embree::check(device_.get(), "starting");
    add_copies(work);
    scene_.reset(rtcNewScene(device_.get()));
    if (work) {
        rtcSetSceneProgressMonitorFunction(
            scene_.get(),
            [](void* asked, double) { return static_cast<SharedProgress*>(asked)->keep_going(); },
            work);
    }
    if (!discs_.empty()) {
        RTCGeometry geometry = rtcNewGeometry(device_.get(), RTC_GEOMETRY_TYPE_ORIENTED_DISC_POINT);
        // Embree reads centre and radius as one vector of four, the normal as one of three.
        static_assert(offsetof(Disc, radius_um) == 12 && offsetof(Disc, normal) == 16 &&
                      sizeof(Disc) == 32);
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT4,
                                   discs_.data(), 0, sizeof(Disc), discs_.size());
        rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_NORMAL, 0, RTC_FORMAT_FLOAT3,
                                   discs_.data(), offsetof(Disc, normal), sizeof(Disc),
                                   discs_.size());
        rtcCommitGeometry(geometry);
        rtcAttachGeometry(scene_.get(), geometry);
        rtcReleaseGeometry(geometry);
        embree::check(device_.get(), "making discs");
    }
    rtcCommitScene(scene_.get());
    if (work) {
        work->throw_if_stopped(kBuilding);
        rtcSetSceneProgressMonitorFunction(scene_.get(), nullptr, nullptr);
    }
    embree::check(device_.get(), "building the paint");
}

DiscScene::~DiscScene() = default;

// Every disc at all places, other than its own, from which it reaches into the tile.
void DiscScene::add_copies(SharedProgress* work) {
    const auto width = static_cast<float>(tile_.width_um);
    const auto height = static_cast<float>(tile_.height_um);
    // Distance, in tiles, from which a copy can reach in: more than one if a flake is wider than a
    // tile.
    const auto reach = [](float radius, float side) { return 1 + static_cast<int>(radius / side); };
    for (std::size_t i = 0; i < count_; ++i) {
        if (work) work->throw_if_stopped(kBuilding);
        const Disc disc = discs_[i];
        const float r = disc.radius_um, x = disc.centre_um.x, y = disc.centre_um.y;
        if (x >= r && x + r <= width && y >= r && y + r <= height) continue;
        const int across = reach(r, width), along = reach(r, height);
        for (int a = -across; a <= across; ++a) {
            for (int b = -along; b <= along; ++b) {
                if (a == 0 && b == 0) continue;
                Disc copy = disc;
                copy.centre_um.x += static_cast<float>(a) * width;
                copy.centre_um.y += static_cast<float>(b) * height;
                if (copy.centre_um.x > -r && copy.centre_um.x < width + r &&
                    copy.centre_um.y > -r && copy.centre_um.y < height + r) {
                    discs_.push_back(copy);
                }
            }
        }
    }
}

std::optional<DiscScene::Hit> DiscScene::intersect(Vec3f origin_um, Vec3f direction,
                                                   float distance_um, std::uint32_t leaving) const {
    RTCRayHit query;
    query.ray.org_x = origin_um.x;
    query.ray.org_y = origin_um.y;
    query.ray.org_z = origin_um.z;
    query.ray.dir_x = direction.x;
    query.ray.dir_y = direction.y;
    query.ray.dir_z = direction.z;
    query.ray.tnear = leaving == kNone ? 0 : kMinFlight_um;
    query.ray.time = 0;
    query.ray.mask = ~0u;
    query.ray.id = 0;
    query.ray.flags = 0;
    for (;;) {
        query.ray.tfar = distance_um;
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
        embree::intersect(scene_.get(), query, false);
        if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {};
        if (query.hit.primID != leaving) return Hit{query.ray.tfar, query.hit.primID};
        // Rounding has put the start on the disc's other side: on from behind it.
        query.ray.tnear = std::nextafter(query.ray.tfar, std::numeric_limits<float>::infinity());
        leaving = kNone;
    }
}

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

Visibility flake_visibility(const DiscScene& scene, Vec3f towards_light, Vec3f towards_detector,
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
                visible = lit && is_free(scene, point, towards_detector, number);
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

}  // namespace nacre::montecarlo
