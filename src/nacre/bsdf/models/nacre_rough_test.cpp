#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "nacre/core/math.h"
#include "nacre/core/quadrature.h"
#include "nacre/optics/fresnel.h"
#include "nacre/testing/nacre_model.h"
#include "nacre/testing/statistics.h"

// Single flakes under a rough clearcoat: matte and satin paint.

namespace nacre::bsdf {
namespace {

using test::kWorstZ;
using test::Sample;

constexpr double kCoatIndex = 1.5;

struct Vector {
    double x, y, z;
};
Vector operator*(double s, Vector v) { return {s * v.x, s * v.y, s * v.z}; }
Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
double product(Vector a, Vector b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vector unit(Vector v) { return 1 / std::sqrt(product(v, v)) * v; }

// What follows knows nothing of lobes or of half vectors: light is refracted by a facet, mirrored
// by a flake, spread by the Airy pattern and refracted by another facet.
class FacetsAndFlakes {
 public:
    FacetsAndFlakes(double coat_roughness, double diameter_um, std::uint64_t seed)
        : roughness_(coat_roughness), pattern_(0.55 / kCoatIndex / diameter_um), rng_(seed) {
        // The light within x = pi d |q| / lambda' of the Airy pattern.
        for (int i = 0; i <= kRadii; ++i) {
            const double x = radius_at(i);
            encircled_.push_back(1 - std::pow(std::cyl_bessel_j(0.0, x), 2) -
                                 std::pow(std::cyl_bessel_j(1.0, x), 2));
        }
    }

    /// Light that goes from wi (outside) to a lamp by a flake of this slope; a random value whose
    /// mean is in proportion to it.
    double walk(Vector wi, double slope_x, double slope_y, Vector lamp, double cos_lamp) {
        double weight = 1;
        const Vector in = cross_facet(wi, 1 / kCoatIndex, weight);
        const Vector normal = unit({slope_x, slope_y, 1});
        if (weight == 0 || in.z <= 0) return 0;
        const double facing = product(in, normal);
        if (facing <= 0) return 0;
        weight *= facing / (in.z * normal.z);
        Vector out = 2 * facing * normal + -1 * in;
        out = diffracted(out, normal);
        if (out.z <= 0) return 0;
        const Vector left = cross_facet(out, kCoatIndex, weight);
        if (weight == 0 || left.z <= 0) return 0;
        return product(left, lamp) > cos_lamp ? weight : 0;
    }
    Rng& rng() { return rng_; }

 private:
    static constexpr int kRadii = 4000;
    static double radius_at(int i) { return 0.1 * i; }

    Vec2f gaussian(double alpha) {
        const double r = alpha * std::sqrt(-std::log(1 - rng_.uniform_double()));
        const double angle = 2 * std::numbers::pi * rng_.uniform_double();
        return {static_cast<float>(r * std::cos(angle)), static_cast<float>(r * std::sin(angle))};
    }
    // The direction w on one side of a random facet, refracted; `ratio` is the index of that side over
    // that of the other. Both directions point upwards, the one against the light. Facets count by
    // the area that w sees of them.
    Vector cross_facet(Vector w, double ratio, double& weight) {
        const Vec2f slope = gaussian(roughness_);
        const Vector m = unit({slope.x, slope.y, 1});
        const double cosine = product(w, m), sine2 = ratio * ratio * (1 - cosine * cosine);
        if (cosine <= 0 || sine2 >= 1) {
            weight = 0;
            return w;
        }
        weight *=
            cosine / (m.z * w.z) * (1 - optics::dielectric_reflectance(1.0, 1 / ratio, cosine));
        return ratio * w + (std::sqrt(1 - sine2) - ratio * cosine) * m;  // Snell's law for vectors
    }
    Vector diffracted(Vector out, Vector normal) {
        const double u = rng_.uniform_double();
        const auto above = std::upper_bound(encircled_.begin(), encircled_.end(), u);
        if (above == encircled_.end()) return {0, 0, -1};  // the last two thousandths
        const auto i = static_cast<int>(above - encircled_.begin());
        const double f = (u - encircled_[i - 1]) / (encircled_[i] - encircled_[i - 1]);
        const double q = pattern_ / std::numbers::pi * (radius_at(i - 1) + 0.1 * f);
        const double angle = 2 * std::numbers::pi * rng_.uniform_double();
        const Vector a = unit({normal.z, 0, -normal.x});
        const Vector b = {normal.y * a.z - normal.z * a.y, normal.z * a.x - normal.x * a.z,
                          normal.x * a.y - normal.y * a.x};
        const Vector across = out + -product(out, normal) * normal + q * std::cos(angle) * a +
                              q * std::sin(angle) * b;
        const double along2 = 1 - product(across, across);
        if (along2 <= 0) return {0, 0, -1};
        return across + std::sqrt(along2) * normal;
    }

    double roughness_, pattern_;
    Rng rng_;
    std::vector<double> encircled_;
};

Vector towards(double theta_deg, double phi_deg) {
    const double s = std::sin(theta_deg * kDegree);
    return {s * std::cos(phi_deg * kDegree), s * std::sin(phi_deg * kDegree),
            std::cos(theta_deg * kDegree)};
}

struct RoughCase {
    double roughness, theta_i, theta_o, phi, alpha, diameter_um;
    /// E[L^2] / E[L]^2 over the slopes of flakes, L what a flake reflects into the lamp, by 15 million
    /// walks for each of the two, and its standard error.
    double counted, error;
};
constexpr double kLamp_deg = 4;
constexpr RoughCase kRoughCases[] = {
    {0.05, 10, 10, 180, 0.1, 20, 18.65, 0.27}, {0.1, 10, 10, 180, 0.1, 20, 7.61, 0.12},
    {0.2, 10, 10, 180, 0.1, 20, 2.733, 0.055}, {0.05, 45, 45, 180, 0.1, 20, 12.33, 0.15},
    {0.1, 45, 45, 180, 0.1, 20, 4.627, 0.062}, {0.2, 45, 45, 180, 0.1, 20, 1.924, 0.038},
    {0.1, 45, 30, 180, 0.1, 20, 8.81, 0.12},   {0.2, 45, 25, 170, 0.15, 40, 6.09, 0.11},
    {0.1, 20, 20, 180, 0.2, 8, 19.62, 0.32}};

// Flakes of slopes beyond this about the half vector answer less than once in a thousand times.
double reach_of(const RoughCase& c) { return 0.02 + 1.1 * c.roughness + 0.3 / c.diameter_um; }

// The numbers above, by fewer walks.
TEST(NacreRough, FacetsAndFlakesReflectAsTheyWereCounted) {
    for (const RoughCase& c : {kRoughCases[0], kRoughCases[4], kRoughCases[7]}) {
        FacetsAndFlakes paint(c.roughness, c.diameter_um, 17);
        const Vector wi = towards(c.theta_i, 0), lamp = towards(c.theta_o, c.phi);
        const double cos_lamp = std::cos(0.5 * kLamp_deg * kDegree);
        const auto inside_z = [](const Vector& w) {
            return std::sqrt(1 - (w.x * w.x + w.y * w.y) / (kCoatIndex * kCoatIndex));
        };
        const double z = kCoatIndex * (inside_z(wi) + inside_z(lamp));
        constexpr int kFlakes = 10000, kWalks = 100;
        Sample once, twice;
        Rng& rng = paint.rng();
        for (int n = 0; n < kFlakes * kWalks; ++n) {
            const double r = c.alpha * std::sqrt(-std::log(1 - rng.uniform_double()));
            const double angle = 2 * std::numbers::pi * rng.uniform_double();
            once.add(paint.walk(wi, r * std::cos(angle), r * std::sin(angle), lamp, cos_lamp));
        }
        for (int k = 0; k < kFlakes; ++k) {
            const double r = reach_of(c) * std::sqrt(rng.uniform_double());
            const double angle = 2 * std::numbers::pi * rng.uniform_double();
            const double x = (wi.x + lamp.x) / z + r * std::cos(angle);
            const double y = (wi.y + lamp.y) / z + r * std::sin(angle);
            double sum = 0, squares = 0;
            for (int n = 0; n < kWalks; ++n) {
                const double v = paint.walk(wi, x, y, lamp, cos_lamp);
                sum += v;
                squares += v * v;
            }
            // Density of slopes over that of those drawn, and L^2 by two walks at a time.
            twice.add(reach_of(c) * reach_of(c) / (c.alpha * c.alpha) *
                      std::exp(-(x * x + y * y) / (c.alpha * c.alpha)) * (sum * sum - squares) /
                      (kWalks * (kWalks - 1.0)));
        }
        const double found = twice.mean() / (once.mean() * once.mean());
        const double error =
            found * std::hypot(twice.error() / twice.mean(), 2 * once.error() / once.mean());
        EXPECT_LT(error, 0.1 * found);
        EXPECT_NEAR(found, c.counted, kWorstZ * std::hypot(error, c.error)) << c.roughness;
    }
}

// The same by the model.
double modelled(const RoughCase& c, double lamp_deg) {
    const sparkle::DiffractionLobe lobe(c.alpha, kCoatIndex, c.roughness);
    sparkle::FlakeView view;
    view.count = 1;
    view.background = 0;
    view.weight[0] = 1;
    view.weight_sum = 1;
    view.typical_radius =
        static_cast<float>(lobe.radius(static_cast<float>(c.diameter_um)) / c.alpha);
    store_lanes(&view.lobe_radius[0], FloatLanes{});
    view.lobe_radius[0] = lobe.radius(static_cast<float>(c.diameter_um));
    const Vec3f wi = refract_in(direction(c.theta_i, 0), 1 / 1.5f);
    struct Point {
        Vec2f slope;
        float cosine, spread2;
        double weight;
    };
    std::vector<Point> lamp;
    const Vec3f middle = direction(c.theta_o, c.phi);
    const Frame frame = Frame::around(middle);
    double mean = 0;
    for (int k = 0; k < 7; ++k) {  // exact for cubics on the disc
        const double r = k == 0 ? 0 : std::sqrt(2.0 / 3) * 0.5 * lamp_deg * kDegree;
        const double angle = k * std::numbers::pi / 3;
        const Vec3f wo =
            refract_in(normalize(middle + static_cast<float>(r * std::cos(angle)) * frame.s +
                                 static_cast<float>(r * std::sin(angle)) * frame.t),
                       1 / 1.5f);
        const Vec3f h = wi + wo;
        Point p{{h.x / h.z, h.y / h.z},
                0.5f * length(h),
                lobe.coat().spread2(wi.z, wo.z),
                k == 0 ? 0.25 : 0.125};
        // The light of the mean: Gaussian slopes, spread.
        const double slope2 = p.slope.x * p.slope.x + p.slope.y * p.slope.y;
        const double alpha2 = c.alpha * c.alpha + p.spread2;
        p.weight *= std::exp(-slope2 / alpha2) / alpha2;
        mean += p.weight;
        lamp.push_back(p);
    }
    const double reach = reach_of(c);
    constexpr int kSide = 160;
    double sum = 0;
    for (int i = 0; i < kSide * kSide; ++i) {
        const double x = lamp[0].slope.x + reach * (2 * (i % kSide + 0.5) / kSide - 1);
        const double y = lamp[0].slope.y + reach * (2 * (i / kSide + 0.5) / kSide - 1);
        view.slope_x[0] = static_cast<float>(x);
        view.slope_y[0] = static_cast<float>(y);
        double response = 0;
        for (const Point& p : lamp) {
            response += p.weight / mean * view.fraction(lobe, p.slope, p.cosine, 0, p.spread2);
        }
        sum += response * response * std::exp(-(x * x + y * y) / (c.alpha * c.alpha)) /
               (std::numbers::pi * c.alpha * c.alpha) * 4 * reach * reach / (kSide * kSide);
    }
    return sum;
}

TEST(NacreRough, ContrastIsThatOfFacetsAndFlakes) {
    for (const RoughCase& c : kRoughCases) {
        // Contrast goes with the root.
        const double ratio = std::sqrt(modelled(c, kLamp_deg) / c.counted);
        EXPECT_NEAR(ratio, 1,
                    sparkle::DiffractionLobe::kSpreadError + 3 * 0.5 * c.error / c.counted)
            << c.roughness << ' ' << c.theta_i;
    }
}

// On points: Var X = slopes E[V^2] / E[V]^2 / (nu a), the number of flakes that cover a point being Poisson.
TEST(NacreRough, VarianceIsThatOfACompoundPoissonProcess) {
    for (const RoughCase& c : {kRoughCases[1], kRoughCases[5]}) {
        paint::Recipe recipe = paint_of({metal_flake(c.diameter_um, 0.6, c.alpha)});
        recipe.clearcoat = paint::Clearcoat{0, spectra::Spectrum(0.0), c.roughness};
        const SparklingModel model(recipe);
        const Vec3f wi = direction(c.theta_i, 0), wo = direction(c.theta_o, c.phi);
        const double single = model.paint->brdf(c.theta_i * kDegree, c.theta_o * kDegree,
                                                c.phi * kDegree, Part::single)[15];
        const double mean = model.bound->eval(wi, wo)[3];
        Sample squares;
        Rng rng(5, 1);
        PatchMemory memory(model.bound->patch_memory_bytes());
        for (int n = 0; n < 100000; ++n) {
            Patch patch = random_square_patch(rng, 0);
            patch.memory = &memory;
            memory.forget();
            const double x = (model.bound->evaluate_on(patch, wi, wo).f[3] - mean) / single;
            squares.add(x * x);
        }
        const solver::LayerMedium& layer = model.paint->medium.layers[0];
        double depth = 0;
        for (const double theta : {c.theta_i, c.theta_o}) {
            const double mu = solver::inside_cosine(kCoatIndex, theta * kDegree);
            depth += solver::extinction(layer, mu, 0)[0] / mu * layer.thickness_um;
        }
        const double v2 = depth / 2 * (1 + std::exp(-depth)) / -std::expm1(-depth);
        const double cover = 0.1 * 15;
        const double expected = modelled(c, 0) * v2 / cover;
        EXPECT_LT(squares.error(), 0.05 * expected);
        // The table of the single scattering has kMicroflakeRoughError of its own.
        EXPECT_NEAR(squares.mean(), expected,
                    kWorstZ * squares.error() + 2 * kMicroflakeRoughError * expected);
    }
}

// The least roughness that a recipe may have, over flakes whose lobes it widens by less than 1 %.
TEST(NacreRough, IsSmoothInTheLimit) {
    paint::Recipe recipe = paint_of({metal_flake(4, 0.6, 0.2)});
    const SparklingModel smooth(recipe);
    recipe.clearcoat = paint::Clearcoat{0, spectra::Spectrum(0.0), 0.01};
    const SparklingModel rough(recipe);
    Rng rng(6, 1);
    double difference = 0, sparkle = 0;
    for (int n = 0; n < 3000; ++n) {
        const Patch patch = random_square_patch(rng, 0.02);
        const double theta = 60 * rng.uniform_double();
        const Vec3f wi = direction(theta, 0);
        const Vec3f wo = direction(theta + 2, 178);
        const auto x = [&](const SparklingModel& model) {
            return model.bound->evaluate_on(patch, wi, wo).f[3] - model.bound->eval(wi, wo)[3];
        };
        difference += std::abs(x(rough) - x(smooth));
        sparkle += std::abs(x(smooth));
    }
    EXPECT_LT(difference, 0.02 * sparkle);
}

}  // namespace
}  // namespace nacre::bsdf
