#include "nacre/discs/disc_scene.h"

#include <fmt/format.h>

#include <cmath>
#include <cstddef>
#include <limits>

#include "nacre/core/embree.h"
#include "nacre/core/error.h"

namespace nacre::discs {
namespace {

/// From one disc to the next light goes at least this far. Where two discs cross, rounding can put
/// it in front of either for ever. One flake in 1e5 that is so near is missed.
constexpr float kLeastFlightUm = 1e-4f;

}  // namespace

DiscScene::DiscScene(std::vector<Disc> discs, const Tile& tile)
    : tile_(tile),
      count_(discs.size()),
      discs_(std::move(discs)),
      device_(rtcNewDevice(nullptr), [](RTCDeviceTy* d) { rtcReleaseDevice(d); }),
      scene_(nullptr, [](RTCSceneTy* s) { rtcReleaseScene(s); }) {
    embree::check(device_.get(), "starting");
    add_copies();
    scene_.reset(rtcNewScene(device_.get()));
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
    embree::check(device_.get(), "building the paint");
}

DiscScene::~DiscScene() = default;

// Every disc at all places, other than its own, from which it reaches into the tile.
void DiscScene::add_copies() {
    const auto width = static_cast<float>(tile_.width_um);
    const auto height = static_cast<float>(tile_.height_um);
    // How many tiles away a copy can reach in from: more than one if a flake is wider than a tile.
    const auto reach = [](float radius, float side) { return 1 + static_cast<int>(radius / side); };
    for (std::size_t i = 0; i < count_; ++i) {
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
    query.ray.tnear = leaving == kNone ? 0 : kLeastFlightUm;
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

}  // namespace nacre::discs
