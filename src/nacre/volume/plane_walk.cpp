#include "nacre/volume/plane_walk.h"

#include "nacre/reference/depth_walk.h"
#include "nacre/volume/bound_walk.h"

namespace nacre::volume {
namespace {

using reference::WalkState;

/// Lets light out by lot.
class WayOut {
 public:
    WayOut(const reference::AirInterface& interface, RandomStream& random)
        : interface_(interface), random_(random) {}

    bool follows(const WalkState&) const { return true; }
    void flies(const WalkState&, const reference::Slab&, double, double) const {}
    void lands(const Lanes&) const {}
    bool lifts(const Lanes&) const { return true; }
    void surfaces(WalkState& state) {
        const auto passage = interface_.meet_from_inside(state.travel, random_);
        state.travel = passage.travel;
        if (passage.inside) return;
        state.alive = false;
        escape = Escape{.direction = passage.travel, .weight = state.weight};
    }

    std::optional<Escape> escape;

 private:
    const reference::AirInterface& interface_;
    RandomStream& random_;
};

class BoundPlaneWalk final : public BoundWalk {
 public:
    BoundPlaneWalk(const WalkTables& tables, const bsdf::Wavelengths& wavelengths_nm)
        : BoundWalk(tables, wavelengths_nm) {
        weigh_mirror();
    }

 private:
    std::optional<Escape> follow(const Entry& entry, RandomStream& random) const override {
        WayOut way_out(interface(entry.lane), random);
        reference::DepthWalk(medium(), random, way_out).run(entry.travel, entry.weight);
        return way_out.escape;
    }
};

}  // namespace

PlaneWalk::PlaneWalk(const layers::Recipe& recipe, const std::vector<double>& wavelengths_nm)
    : tables_(std::make_shared<const WalkTables>(recipe, wavelengths_nm)) {
    // Says now, not at the first picture, what is wrong with a rough interface.
    reference::make_air_interface(recipe, tables_->grid.index(wavelengths_nm.front()));
}

PlaneWalk::~PlaneWalk() = default;

std::unique_ptr<const bsdf::BoundBsdf> PlaneWalk::bind(
    const bsdf::Wavelengths& wavelengths_nm) const {
    return std::make_unique<BoundPlaneWalk>(*tables_, wavelengths_nm);
}

}  // namespace nacre::volume
