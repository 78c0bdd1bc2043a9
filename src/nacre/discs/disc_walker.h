#pragma once

#include <optional>
#include <vector>

#include "nacre/discs/disc_scene.h"
#include "nacre/discs/flake_films.h"
#include "nacre/volume/bound_walk.h"

namespace nacre::discs {

using reference::Direction3;
using reference::Lanes;
using reference::RandomStream;

/// What all walks at eight wavelengths share.
struct DiscPaint {
    const DiscScene& discs;
    const std::vector<FlakeFilms>& films;  ///< by species
    const reference::Medium& medium;       ///< all but the flakes
    WavelengthPlaces places;
    bool diffraction = true;
    double wavelength_um = 0.55;  ///< mean of the eight, in vacuum
};

/// One walk through a paint of discs, in the frame of the tile: x and y within it, z = 0 at the
/// interface and z > 0 outwards.
class DiscWalker {
 public:
    DiscWalker(const DiscPaint& paint, const reference::AirInterface& interface, double index,
               RandomStream& random)
        : paint_(paint), interface_(interface), index_(index), random_(random) {}

    /// @param x_um, y_um  where light comes in, anywhere: taken modulo the tile
    /// @param travel      inside the paint, z < 0
    std::optional<volume::Escape> run(double x_um, double y_um, const Direction3& travel,
                                      const Lanes& weight);

 private:
    void fly();
    void meet_disc(std::uint32_t disc);
    Direction3 spread(const Direction3& mirrored, const Direction3& normal, double diameter_um);
    void meet_pigment(const reference::Slab& slab);
    void descend();
    void ascend();
    void roulette();

    const DiscPaint& paint_;
    const reference::AirInterface& interface_;
    double index_;
    RandomStream& random_;

    Direction3 position_, moved_, travel_;
    std::uint32_t leaving_ = DiscScene::kNone;
    std::size_t slab_ = 0;
    double slab_top_ = 0;  ///< z of the top of the slab
    Lanes weight_{};
    bool alive_ = true;
    std::optional<volume::Escape> escape_;
};

}  // namespace nacre::discs
