#include "nacre/solver/fourier_kernel.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "nacre/paint/beckmann.h"
#include "nacre/solver/lane_matrix.h"
#include "nacre/testing/layers.h"

namespace nacre::solver {
namespace {

using test::kOneWavelength;

// Relative to order 0 of the same pair. R is linear between 512 cosines: (1/512)^2/8 R'' = 6e-7,
// over R >= 0.2. Single precision and the exp(-22) of a lobe that is left out are less.
constexpr double kKernelError = 4e-6;

// R = 0.2 + 0.6 (1 - cos)^2: some dependence on angle.
double reflectance(double cosine) { return 0.2 + 0.6 * (1 - cosine) * (1 - cosine); }

LayerMedium flake_layer(double alpha) {
    std::vector<double> r, t;
    for (double c : paint::chebyshev_cosines(5)) {
        r.push_back(reflectance(c));
        t.push_back(0.1);
    }
    return {10, {{0.1, alpha, paint::FlakeTable::from_chebyshev(5, 1, r, t)}}, {}};
}
LayerMedium pigment_layer(double g) { return {10, {}, {{{0.03}, {0.01}, g}}}; }

// Legendre coefficients of no simple law, negative ones among them.
const std::vector<double> kSeries = {1, 0.4, 0.3, 0.12, 0.08, -0.02, 0.01};

LayerMedium particle_layer() {
    return {10, {}, {{{0.03}, {0.01}, 0, optics::PhaseFunction({kSeries})}}};
}

// sigma_s p between directions of travel, from vectors: flakes and pigments.
double kernel(const LayerMedium& layer, double mu_i, double mu_j, double phi) {
    const double s_i = std::sqrt(1 - mu_i * mu_i), s_j = std::sqrt(1 - mu_j * mu_j);
    const double x = 1 - mu_i * mu_j - s_i * s_j * std::cos(phi);  // 1 - w.w'
    double sum = 0;
    for (const FlakeMedium& flake : layer.flakes) {
        const double cos_h = std::abs(mu_i - mu_j) / std::sqrt(2 * x);
        if (cos_h < 1e-6) continue;
        const double tan2 = (1 - cos_h * cos_h) / (cos_h * cos_h);
        sum += 0.5 * flake.area_density_per_um * paint::flake_density(tan2, flake.alpha) *
               reflectance(std::sqrt(x / 2));
    }
    for (const PigmentMedium& pigment : layer.pigments) {
        if (pigment.phase) {
            for (std::size_t n = 0; n < kSeries.size(); ++n) {
                sum += pigment.scattering_per_um[0] * (2.0 * n + 1) / (4 * std::numbers::pi) *
                       kSeries[n] * std::legendre(static_cast<unsigned>(n), 1 - x);
            }
            continue;
        }
        const double g = pigment.anisotropy;
        sum += pigment.scattering_per_um[0] * (1 - g * g) /
               (4 * std::numbers::pi * std::pow(1 + g * g - 2 * g * (1 - x), 1.5));
    }
    return sum;
}

// p_l = 1/(2 pi) Int_0^2pi sigma_s p cos l phi dphi; the midpoint rule converges geometrically.
class BruteForce {
 public:
    BruteForce(const LayerMedium& layer, double mu_i, double mu_j) {
        for (int k = 0; k < kCount; ++k) value_[k] = kernel(layer, mu_i, mu_j, phi(k));
    }
    double operator()(int l) const {
        double sum = 0;
        for (int k = 0; k < kCount; ++k) sum += value_[k] * std::cos(l * phi(k));
        return sum / kCount;
    }

 private:
    static constexpr int kCount = 2000;
    static double phi(int k) { return std::numbers::pi * (k + 0.5) / kCount; }
    std::array<double, kCount> value_;
};

void expect_brute_force(const LayerMedium& layer, double alpha, double ior, int orders) {
    const Directions d = make_directions(ior, 12, 8);
    const ActiveNodes active(d, alpha, orders);
    const FourierKernel fourier(layer, d, active, 1);
    int compared = 0;
    for (int i = 0; i < d.size(); i += 3) {
        for (int j = 0; j <= i; j += 2) {
            const BruteForce same(layer, d.mu[i], d.mu[j]), opposite(layer, -d.mu[i], d.mu[j]);
            for (int l = 0; l < active.orders(); l = 2 * l + 1) {
                const int first = active.first(l);
                if (j < first) continue;
                SCOPED_TRACE(testing::Message() << i << ' ' << j << " order " << l);
                const std::size_t at = triangle(i - first) + j - first;
                EXPECT_NEAR(fourier.same(0, l)[at][0], same(l), kKernelError * same(0) + 1e-12);
                EXPECT_NEAR(fourier.opposite(0, l)[at][0], opposite(l),
                            kKernelError * opposite(0) + 1e-12);
                ++compared;
            }
        }
    }
    EXPECT_GT(compared, 50);
}

TEST(FourierKernel, FlakesMatchTheAzimuthalIntegral) {
    for (double alpha : {0.05, 0.3}) expect_brute_force(flake_layer(alpha), alpha, 1.5, 200);
    expect_brute_force(flake_layer(0.5), 0.5, 1.0, 100);
}

TEST(FourierKernel, PigmentsMatchTheAzimuthalIntegral) {
    // The Legendre series against Henyey and Greenstein's closed form.
    for (double g : {0.0, 0.6, 0.9, -0.5}) {
        expect_brute_force(pigment_layer(g), 1.5 * (1 - std::abs(g)), 1.5, 120);
    }
    expect_brute_force(particle_layer(), 0.5, 1.5, 120);
}

TEST(FourierKernel, WavelengthsAreThoseOfEachAlone) {
    const int count = kLanes + 2;
    const auto layer_of = [](int first, int wavelengths) {
        std::vector<double> reflectance, scattering;
        for (int w = first; w < first + wavelengths; ++w) {
            reflectance.push_back(0.1 + 0.05 * w);
            scattering.push_back(0.01 + 0.002 * w);
        }
        const std::vector<double> none(wavelengths, 0.0);
        return LayerMedium{
            10,
            {{0.1, 0.2, paint::FlakeTable::constant(reflectance, none)},
             {0.05, 0.4, paint::FlakeTable::constant(none, none)}},
            {{scattering, none, 0.3}, {scattering, none, 0, optics::PhaseFunction({kSeries})}}};
    };
    const Directions d = make_directions(1.5, 8, 4);
    const ActiveNodes active(d, 0.2, 40);
    const FourierKernel all(layer_of(0, count), d, active, 2);
    for (int w = 0; w < count; ++w) {
        const FourierKernel alone(layer_of(w, 1), d, active, 1);
        for (int l = 0; l < active.orders(); ++l) {
            for (std::size_t at = 0; at < triangle(d.size() - active.first(l)); ++at) {
                EXPECT_EQ(all.same(w / kLanes, l)[at][w % kLanes], alone.same(0, l)[at][0]);
                EXPECT_EQ(all.opposite(w / kLanes, l)[at][w % kLanes], alone.opposite(0, l)[at][0]);
            }
        }
    }
}

TEST(FourierKernel, OrdersAreThoseOfAllWhateverIsAsked) {
    LayerMedium layer = flake_layer(0.15);
    layer.pigments = {pigment_layer(0.6).pigments[0], particle_layer().pigments[0]};
    const Directions d = make_directions(1.5, 8, 4);
    const ActiveNodes active(d, 0.15, 30);
    const FourierKernel all(layer, d, active, 1);
    for (const OrderRange range : {OrderRange{0, 8}, OrderRange{8}, OrderRange{5, 11}}) {
        const FourierKernel some(layer, d, active, 1, nullptr, range);
        for (int l = range.begin; l < std::min(range.end, active.orders()); ++l) {
            for (std::size_t at = 0; at < triangle(d.size() - active.first(l)); ++at) {
                ASSERT_EQ(some.same(0, l)[at][0], all.same(0, l)[at][0]) << l;
                ASSERT_EQ(some.opposite(0, l)[at][0], all.opposite(0, l)[at][0]) << l;
            }
        }
    }
}

TEST(FourierKernel, OrderZeroSumsToTheScatteringCrossSection) {
    // 2 pi sum_j w_j (same + opposite) = sigma_s for smooth kernels.
    const Directions d = make_directions(1.5, 24, 20);
    for (const LayerMedium& layer : {pigment_layer(0.5), flake_layer(0.5)}) {
        const FourierKernel fourier(layer, d, ActiveNodes(d, 0.3, 1), 1);
        for (int i = 0; i < d.exit_count; ++i) {
            double sum = 0;
            for (int j = 0; j < d.size(); ++j) {
                const std::size_t at = triangle(std::max(i, j)) + std::min(i, j);
                sum += 2 * std::numbers::pi * d.weight[j] *
                       (fourier.same(0, 0)[at][0] + fourier.opposite(0, 0)[at][0]);
            }
            const double exact =
                extinction(layer, d.mu[i], 0)[0] - losses(layer, d.mu[i], 0, 1).absorption[0][0];
            // Flakes have a kink |mu - mu'| in the hemisphere of travel.
            const double error = layer.flakes.empty() ? 1e-6 : 1e-3;
            EXPECT_NEAR(sum, exact, error * exact) << i;
        }
    }
}

TEST(ActiveNodes, LeaveOutOnlyWhatIsNegligible) {
    // e^(-B) I_l(B) falls below 1e-5 of order 0 where a node is dropped.
    const double alpha = 0.1;
    const Directions d = make_directions(1.5, 16, 12);
    const ActiveNodes active(d, alpha, 150);
    const LayerMedium layer = flake_layer(alpha);
    int dropped = 0;
    for (int l = 0; l < active.orders(); ++l) {
        EXPECT_EQ(active.first(l) % kTile, 0);
        if (l > 0) {
            EXPECT_GE(active.first(l), active.first(l - 1));
        }
        const int i = active.first(l) - 1;  // the last node without this order
        if (i < 0 || l % 10 != 0) continue;
        ++dropped;
        EXPECT_LE(active.order_count(i), l);
        const BruteForce exact(layer, -d.mu[i], d.mu[i]);
        EXPECT_LT(std::abs(exact(l)), 1e-5 * exact(0)) << l;
    }
    EXPECT_GT(dropped, 3);
}

}  // namespace
}  // namespace nacre::solver
