#include "nacre/reference/air_interface.h"

#include <algorithm>
#include <cmath>

#include "nacre/core/error.h"
#include "nacre/optics/dielectric.h"

namespace nacre::reference {
namespace {

class SmoothInterface final : public AirInterface {
 public:
    explicit SmoothInterface(double index) : index_(index) {}

    Weighted enter(const Direction3& towards_light, RandomStream&) const override {
        return {-refract_inwards(towards_light), transmittance(towards_light.z())};
    }

    Weighted reflect_inside(const Direction3& travel, RandomStream&) const override {
        return {Direction3(travel.x(), travel.y(), -travel.z()),
                optics::dielectric_reflectance(index_, 1.0, travel.z())};
    }

    Passage meet_from_outside(const Direction3& towards_light,
                              RandomStream& random) const override {
        if (random.uniform() < transmittance(towards_light.z()))
            return {-refract_inwards(towards_light), true};
        return {{-towards_light.x(), -towards_light.y(), towards_light.z()}, false};
    }

    Passage meet_from_inside(const Direction3& travel, RandomStream& random) const override {
        if (random.uniform() < optics::dielectric_reflectance(index_, 1.0, travel.z()))
            return {{travel.x(), travel.y(), -travel.z()}, true};
        const double x = travel.x() * index_, y = travel.y() * index_;
        return {{x, y, std::sqrt(std::max(0.0, 1 - x * x - y * y))}, false};
    }

    // Radiance over index squared is kept but for what Fresnel reflects: a cone outside is n^2
    // times wider, projected, than its image inside.
    Weighted connect(const Direction3& towards_eye, RandomStream&) const override {
        return {refract_inwards(towards_eye), transmittance(towards_eye.z()) / (index_ * index_)};
    }

    bool scatters() const override { return false; }

    double reflect_outside(const Direction3&, const Direction3&, RandomStream&) const override {
        return 0;
    }

 private:
    /// Of light from outside, and along the same ray from inside (Stokes).
    double transmittance(double cosine_outside) const {
        return 1 - optics::dielectric_reflectance(1.0, index_, cosine_outside);
    }

    /// The unit vector inside along which a ray from (or to) `outside` goes on; z > 0.
    Direction3 refract_inwards(const Direction3& outside) const {
        const double x = outside.x() / index_, y = outside.y() / index_;
        return {x, y, std::sqrt(1 - x * x - y * y)};
    }

    double index_;
};

}  // namespace

std::unique_ptr<const AirInterface> make_smooth_interface(double index) {
    return std::make_unique<SmoothInterface>(index);
}

std::unique_ptr<const AirInterface> make_air_interface(const layers::Recipe& recipe, double index) {
    const double roughness = recipe.clearcoat ? recipe.clearcoat->roughness : 0;
    if (roughness > 0 && roughness < kLeastRoughness) {
        throw DomainError(fmt::format(
            "clearcoat.roughness = {} is too small for the reference to follow masked light: 0, or "
            "at least {}",
            roughness, kLeastRoughness));
    }
    // Equal indices are no interface, however rough.
    if (roughness > 0 && index > 1) return make_rough_interface(index, roughness);
    return make_smooth_interface(index);
}

}  // namespace nacre::reference
