#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "nacre/core/vec.h"
#include "nacre/montecarlo/discs/disc.h"

// Embree's handles, named here so that its headers stay out of ours.
struct RTCDeviceTy;
struct RTCSceneTy;

namespace nacre::montecarlo {

/// The discs of a tile, ready for rays. Immutable, shared between threads.
class DiscScene {
 public:
    /// @param discs  with their centres in the tile; those that reach over an edge are met from the
    ///               other side too
    /// @throws Error if the ray tracer runs out of memory; Stopped if `work`, which is asked where it
    ///         is not null, says so
    DiscScene(std::vector<Disc> discs, const Tile& tile, SharedProgress* work = nullptr);
    ~DiscScene();
    DiscScene(const DiscScene&) = delete;
    DiscScene& operator=(const DiscScene&) = delete;

    static constexpr std::uint32_t kNone = ~0u;

    struct Hit {
        float distance_um;
        std::uint32_t disc;
    };
    /// The first disc along a ray that starts in the tile.
    /// @param distance_um  where the ray ends, at the latest where it leaves the tile
    /// @param leaving      the disc on which it starts, or kNone: it does not meet a flat disc
    ///                     again, nor another at the very same place
    std::optional<Hit> intersect(Vec3f origin_um, Vec3f direction, float distance_um,
                                 std::uint32_t leaving) const;

    const Disc& operator[](std::uint32_t disc) const { return discs_[disc]; }
    const Tile& tile() const { return tile_; }
    /// Number of flakes in the tile.
    std::size_t count() const { return count_; }

 private:
    void add_copies(SharedProgress* work);

    Tile tile_;
    std::size_t count_;
    std::vector<Disc> discs_;  // from count_ on: copies, a tile away, that reach over an edge
    std::unique_ptr<RTCDeviceTy, void (*)(RTCDeviceTy*)> device_;
    std::unique_ptr<RTCSceneTy, void (*)(RTCSceneTy*)> scene_;
};

/// The visible fraction v of a flake: that of its area from which straight paths reach both the
/// light and the detector past all other flakes. Its moments over the flakes of a tile.
struct Visibility {
    double lit = 0;             ///< mean fraction of a flake that is lit
    double bidirectional = 0;   ///< E[v]
    double mean_square = 0;     ///< E[v^2], which sets the contrast of whole flakes
    double standard_error = 0;  ///< of bidirectional
};

/// Estimated from two random points on each flake, the mean product of whose visibilities is
/// E[v^2].
///
/// @param towards_light, towards_detector  unit vectors inside the paint, z > 0
Visibility flake_visibility(const DiscScene& scene, Vec3f towards_light, Vec3f towards_detector,
                            std::uint64_t seed);

}  // namespace nacre::montecarlo
