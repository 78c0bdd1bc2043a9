#pragma once

#include <optional>

#include "nacre/volume/bound_walk.h"
#include "nacre/volume/free_flight.h"
#include "nacre/volume/shell_walk.h"

namespace nacre::volume {

/// One walk through a shell of paint, in the frame of its entry: the origin lies on the outer
/// sphere, whose centre is at -z / curvature.
class ShellWalker {
 public:
    /// @param curvature_per_um  of the outer sphere; 0 is a flat slab
    ShellWalker(const reference::Medium& medium, double index, double curvature_per_um,
                const ShellSettings& settings, RandomStream& random)
        : medium_(medium),
          index_(index),
          outer_curvature_(curvature_per_um),
          settings_(settings),
          random_(random) {}

    /// @param travel  inside the paint, z < 0
    std::optional<Escape> run(const Direction3& travel, const Lanes& weight);

 private:
    void fly();
    void collide(const reference::Slab& slab, double lot);
    void meet_flake(const reference::Flakes& species);
    void descend();
    void ascend();
    void roulette();
    Direction3 normal() const;

    const reference::Medium& medium_;
    double index_, outer_curvature_;
    const ShellSettings& settings_;
    RandomStream& random_;

    Direction3 position_, travel_;
    std::size_t slab_ = 0;
    double slab_top_um_ = 0;  ///< depth of the slab's top below the outer sphere
    double depth_um_ = 0;     ///< below the top of the slab: kept for itself, to all digits
    Lanes weight_{};
    bool alive_ = true;
    std::optional<Escape> escape_;
};

}  // namespace nacre::volume
