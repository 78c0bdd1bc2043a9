#include "nacre/montecarlo/interface.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "nacre/optics/fresnel.h"

namespace nacre::montecarlo {
namespace {

class SmoothInterface final : public AirInterface {
 public:
    explicit SmoothInterface(double index) : index_(index) {}

    Weighted enter(const Vec3d& towards_light, RandomStream&) const override {
        return {-refract_inwards(towards_light), transmittance(towards_light.z)};
    }

    Weighted reflect_inside(const Vec3d& travel, RandomStream&) const override {
        return {{travel.x, travel.y, -travel.z},
                optics::dielectric_reflectance(index_, 1.0, travel.z)};
    }

    Passage sample_from_outside(const Vec3d& towards_light, RandomStream& random) const override {
        if (random.uniform() < transmittance(towards_light.z))
            return {-refract_inwards(towards_light), true};
        return {{-towards_light.x, -towards_light.y, towards_light.z}, false};
    }

    Passage sample_from_inside(const Vec3d& travel, RandomStream& random) const override {
        if (random.uniform() < optics::dielectric_reflectance(index_, 1.0, travel.z))
            return {{travel.x, travel.y, -travel.z}, true};
        const double x = travel.x * index_, y = travel.y * index_;
        return {{x, y, std::sqrt(std::max(0.0, 1 - x * x - y * y))}, false};
    }

    // Radiance over index squared is conserved up to Fresnel's transmittance: the projected solid
    // angle of a cone outside is n^2 times that of its image inside.
    Weighted connect(const Vec3d& towards_detector, RandomStream&) const override {
        return {refract_inwards(towards_detector),
                transmittance(towards_detector.z) / (index_ * index_)};
    }

    bool scatters() const override { return false; }

    double reflect_outside(const Vec3d&, const Vec3d&, RandomStream&) const override { return 0; }

 private:
    /// Of light from outside, and along the same ray from inside (Stokes).
    double transmittance(double cosine_outside) const {
        return 1 - optics::dielectric_reflectance(1.0, index_, cosine_outside);
    }

    /// The unit vector inside along which a ray from (or to) `outside` goes on; z > 0.
    Vec3d refract_inwards(const Vec3d& outside) const {
        const double x = outside.x / index_, y = outside.y / index_;
        return {x, y, std::sqrt(1 - x * x - y * y)};
    }

    double index_;
};

}  // namespace

std::unique_ptr<const AirInterface> make_smooth_interface(double index) {
    return std::make_unique<SmoothInterface>(index);
}

std::unique_ptr<const AirInterface> make_air_interface(const paint::Recipe& recipe, double index) {
    const double roughness = recipe.clearcoat ? recipe.clearcoat->roughness : 0;
    // Equal indices are no interface, however rough.
    if (roughness > 0 && index > 1) return make_rough_interface(index, roughness);
    return make_smooth_interface(index);
}

// The rough interface of solver/rough_interface.h by random sampling: its facets, its masking and
// the return of masked light are defined there; here each is drawn, and nothing is integrated.

namespace {

/// Light at the surface. The direction points away from it: up outside, down inside.
struct Ray {
    Vec3d away;
    bool inside = false;
};

Vec3d flipped(const Vec3d& v) { return {v.x, v.y, -v.z}; }

/// Smith's G1 for Beckmann slopes, in its exact form.                [walter-2007], [heitz-2014]
double smith_g1(double cosine, double alpha) {
    const double tangent_sq = (1 - cosine * cosine) / (cosine * cosine);
    if (tangent_sq <= 0) return 1;
    const double a = 1 / (alpha * std::sqrt(tangent_sq));
    return 2 / (1 + std::erf(a) + std::exp(-a * a) / (a * std::sqrt(std::numbers::pi)));
}

class RoughAirInterface final : public AirInterface {
 public:
    RoughAirInterface(double index, double alpha) : index_(index), alpha_(alpha) {}

    Weighted enter(const Vec3d& towards_light, RandomStream& random) const override {
        const Ray ray = scatter({towards_light, false}, random);
        return {ray.away, ray.inside ? 1.0 : 0.0};
    }

    Weighted reflect_inside(const Vec3d& travel, RandomStream& random) const override {
        const Ray ray = scatter({-travel, true}, random);
        return {ray.inside ? ray.away : flipped(travel), ray.inside ? 1.0 : 0.0};
    }

    Passage sample_from_outside(const Vec3d& towards_light, RandomStream& random) const override {
        const Ray ray = scatter({towards_light, false}, random);
        return {ray.away, ray.inside};
    }

    Passage sample_from_inside(const Vec3d& travel, RandomStream& random) const override {
        const Ray ray = scatter({-travel, true}, random);
        return {ray.away, ray.inside};
    }

    // The kernel between basic radiances is symmetric: the light that a detector gets comes from
    // the directions to which light from the detector would go. 1/n^2 turns radiance inside into
    // basic.
    Weighted connect(const Vec3d& towards_detector, RandomStream& random) const override {
        const Ray ray = scatter({towards_detector, false}, random);
        if (!ray.inside) return {{0, 0, 1}, 0};
        return {-ray.away, 1 / (index_ * index_)};
    }

    bool scatters() const override { return true; }

    double reflect_outside(const Vec3d& towards_light, const Vec3d& towards_detector,
                           RandomStream& random) const override {
        double sum = facet_brdf(towards_light, towards_detector);
        // m(light) m(detector) / Int m: the masked fractions by chance; the number of directions,
        // uniform in etendue, that it takes to find one whose light is masked has the mean
        // total / Int m.
        if (is_masked({towards_light, false}, random) &&
            is_masked({towards_detector, false}, random)) {
            std::uint64_t trials = 1;
            while (!is_masked(uniform_in_etendue(random), random)) ++trials;
            sum += static_cast<double>(trials) / (std::numbers::pi * (1 + index_ * index_));
        }
        return sum;
    }

 private:
    /// Exit of light from `from`; if it is masked, from a direction from which light would be
    /// masked too.
    Ray scatter(const Ray& from, RandomStream& random) const {
        Ray to;
        if (leaves(from, random, to)) return to;
        do {
            to = uniform_in_etendue(random);
        } while (!is_masked(to, random));
        return to;
    }

    bool is_masked(const Ray& from, RandomStream& random) const {
        Ray unused;
        return !leaves(from, random, unused);
    }

    /// One meeting with a facet; false if what goes on from it is masked.
    bool leaves(const Ray& from, RandomStream& random, Ray& to) const {
        const Vec3d x = from.inside ? flipped(from.away) : from.away;  // now upwards
        const double n_incident = from.inside ? index_ : 1,
                     n_transmitted = from.inside ? 1 : index_;
        const Vec3d facet = visible_normal(x, random);
        const double cosine = std::min(1.0, dot(x, facet));
        Vec3d y;
        const bool reflected =
            random.uniform() < optics::dielectric_reflectance(n_incident, n_transmitted, cosine);
        if (reflected) {
            y = 2 * cosine * facet - x;
        } else {
            const double ratio = n_incident / n_transmitted;
            y = (ratio * cosine - optics::refracted_cos(n_incident, n_transmitted, cosine)) *
                    facet -
                ratio * x;
        }
        y = normalize(y);
        const double height = reflected ? y.z : -y.z;
        if (!(height > 0) || random.uniform() >= smith_g1(height, alpha_)) return false;
        to = {from.inside ? flipped(y) : y, reflected == from.inside};
        return true;
    }

    /// Draws a facet normal from G1 <x.h> D(h) / x_z. In slopes, with p that along x: the density
    /// is (x_z - x_s p)+ exp(-(p^2 + q^2) / alpha^2), so q is Gaussian, and p is drawn from
    /// (x_z + x_s |p|) exp(-p^2 / alpha^2) and kept with the ratio of the two, at least every
    /// other time.
    Vec3d visible_normal(const Vec3d& x, RandomStream& random) const {
        const double sine = std::hypot(x.x, x.y);
        const double flat = std::sqrt(std::numbers::pi) * x.z, tilted = alpha_ * sine;
        double p;
        do {
            if (random.uniform() * (flat + tilted) < flat) {
                p = alpha_ * std::sqrt(random.exponential()) * std::get<0>(random.cos_sin());
            } else {
                p = alpha_ * std::sqrt(random.exponential()) * (random.uniform() < 0.5 ? -1 : 1);
            }
        } while (random.uniform() * (x.z + sine * std::abs(p)) >= x.z - sine * p);
        const double q = alpha_ * std::sqrt(random.exponential()) * std::get<0>(random.cos_sin());
        const double c = sine > 0 ? x.x / sine : 1, s = sine > 0 ? x.y / sine : 0;
        return normalize(Vec3d{-(p * c - q * s), -(p * s + q * c), 1});
    }

    Ray uniform_in_etendue(RandomStream& random) const {
        const bool inside = random.uniform() * (1 + index_ * index_) >= 1;
        const Vec3d up = sample_lambert(random);
        return {inside ? flipped(up) : up, inside};
    }

    /// Light that met one facet.                                            [walter-2007, eq. 20]
    double facet_brdf(const Vec3d& light, const Vec3d& detector) const {
        const Vec3d h = normalize(light + detector);
        const double cos_sq = h.z * h.z;
        const double density = std::exp((1 - 1 / cos_sq) / (alpha_ * alpha_)) /
                               (std::numbers::pi * alpha_ * alpha_ * cos_sq * cos_sq);
        const double cosine = std::min(1.0, dot(light, h));
        return optics::dielectric_reflectance(1.0, index_, cosine) * density *
               smith_g1(light.z, alpha_) * smith_g1(detector.z, alpha_) /
               (4 * light.z * detector.z);
    }

    double index_, alpha_;
};

}  // namespace

std::unique_ptr<const AirInterface> make_rough_interface(double index, double alpha) {
    return std::make_unique<RoughAirInterface>(index, alpha);
}

}  // namespace nacre::montecarlo
