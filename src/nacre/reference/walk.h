#pragma once

#include <span>
#include <vector>

#include "nacre/reference/air_interface.h"
#include "nacre/reference/medium.h"
#include "nacre/reference/random_stream.h"
#include "nacre/reference/reference.h"

// One random walk through a paint. Only depth is followed: the paint is the same everywhere along
// its plane. See docs/reference.md for the estimators.

namespace nacre::reference {

/// A way out of the paint towards an eye: the inner direction, and all that the radiance loses.
class Connection {
 public:
    Connection(const AirInterface::Weighted& inner, const Medium& medium);

    const Direction3& travel() const { return travel_; }
    bool is_dark() const { return weight_ == 0; }
    /// Radiance outside per unit power scattered per sr and unit area at `depth_um` below the top
    /// of slab number `slab`: attenuation, 1 / mu and the interface's weight.
    Lanes from_slab(std::size_t slab, double depth_um) const;
    /// Radiance outside per unit radiance that leaves the substrate.
    Lanes from_substrate() const;

 private:
    Direction3 travel_;
    double weight_;
    int lane_count_;
    std::vector<Lanes> depth_above_;   // optical depth of the slabs above, along the direction
    std::vector<Lanes> depth_per_um_;  // optical depth per um of depth in the slab
};

/// Receives what a walk contributes.
struct WalkTally {
    std::vector<Lanes> radiance;  ///< per connection, for unit irradiance on the paint
    Lanes reflected{};            ///< power that left upwards, or never came in
    Lanes absorbed_by_substrate{};

    void clear();
};

/// Sends one unit of power in from `towards_light` and adds what becomes of it to `tally`.
/// Reflected and absorbed power are complete only with Part::total.
void walk(const Medium& medium, const AirInterface& interface, const Direction3& towards_light,
          std::span<const Connection> connections, Part part, RandomStream& random,
          WalkTally& tally);

}  // namespace nacre::reference
