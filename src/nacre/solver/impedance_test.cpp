#include "nacre/solver/impedance.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>

#include "nacre/core/dense.h"
#include "nacre/testing/dense.h"
#include "nacre/testing/layers.h"

namespace nacre::solver {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;
using test::Matrices;

// Relative error of the start for modes at the limit of doublings_for: (0.375)^6/1575.
constexpr double kStartError = 1.8e-6;

// A random medium in the form of impedance.h: K+- are symmetric, not negative; extinction is what
// they scatter along the field `flux` plus a fraction `lost`.
struct Medium {
    Matrices e, f;
    MatrixXd flux;  // by lane: the field that a medium without absorption keeps
    double deepest = 0;
};
Medium random_medium(int n, double lost, unsigned seed) {
    const Matrices same = test::random_matrices(n, n, seed);
    const Matrices turn = test::random_matrices(n, n, seed + 100);
    Medium m;
    m.flux.resize(n, kLanes);
    for (int lane = 0; lane < kLanes; ++lane) {
        const MatrixXd k_same = (same[lane] + same[lane].transpose()).cwiseAbs();
        const MatrixXd k_turn = (turn[lane] + turn[lane].transpose()).cwiseAbs() / (1 + lane);
        VectorXd flux(n);
        for (int i = 0; i < n; ++i) flux(i) = 0.2 + std::abs(same[lane](0, i));
        m.flux.col(lane) = flux;
        const VectorXd extinction = ((k_same + k_turn) * flux).cwiseQuotient(flux) / (1 - lost);
        MatrixXd a = -k_same;
        a.diagonal() += extinction;
        m.e[lane] = a - k_turn;
        m.f[lane] = a + k_turn;
        m.deepest = std::max(m.deepest, extinction.maxCoeff());
    }
    return m;
}

// The closed form: with F = L L^T and L^T E L = Q k^2 Q^T, fields w = L^-1 u, y = L^T v obey
// w' = -y, y' = -L^T E L w, so that y = k tanh(k H/2) w for equal light from both sides.
MatrixXd closed_form(const MatrixXd& e, const MatrixXd& f, double thickness, bool equal) {
    const MatrixXd l = test::cholesky(f);
    const SymmetricEigen eigen = symmetric_eigen(test::product(l.transpose(), test::product(e, l)));
    VectorXd z(e.rows());
    for (int i = 0; i < z.size(); ++i) {
        const double k = std::sqrt(std::max(eigen.values(i), 0.0)), x = 0.5 * k * thickness;
        if (equal) {
            z(i) = k * std::tanh(x);
        } else {
            z(i) = x > 1e-7 ? k / std::tanh(x) : 2 / thickness;
        }
    }
    const MatrixXd modes = test::product(eigen.vectors.transpose(), test::inverse(l));
    return test::product(modes.transpose(), z.asDiagonal() * modes);
}

struct Slab {
    LaneBuffer zs, za;
};
Slab slab(const Medium& m, double thickness, int doublings) {
    const int n = static_cast<int>(m.flux.rows());
    Slab s{test::to_lanes(m.e), test::to_lanes(m.f)};
    ImpedanceWorkspace work(n);
    slab_impedance(s.zs.data(), s.za.data(), thickness, doublings, n, work);
    for (int i = 0; i < n; ++i) {
        for (int j = 0; j < i; ++j) s.za[j * n + i] = s.za[i * n + j];
    }
    return s;
}
Slab slab(const Medium& m, double thickness) {
    return slab(m, thickness, doublings_for(thickness * m.deepest));
}

// (1 + z)^-1 (1 - z)
MatrixXd reflection(const MatrixXd& z) {
    const MatrixXd one = MatrixXd::Identity(z.rows(), z.cols());
    return test::product(test::inverse(one + z), one - z);
}

TEST(Impedance, ScalarSlabsAreTheTwoStreamSolution) {
    // Four modes on the diagonal, eight albedos in the lanes: Z_s = r tanh(k H/2),
    // Z_a = r coth(k H/2) with k = sqrt(E F), r = sqrt(E/F).
    constexpr double kAlbedo[kLanes] = {0, 0.3, 0.6, 0.9, 0.99, 0.999, 0.999999, 1};
    constexpr double kExtinction[kTile] = {1, 0.3, 0.01, 1e-4};
    int cases = 0;
    for (double depth = 1e-8; depth < 2e6; depth *= 10) {
        LaneBuffer e(kTile * kTile, DoubleLanes{}), f = e;
        for (int i = 0; i < kTile; ++i) {
            for (int lane = 0; lane < kLanes; ++lane) {
                // Half of what is scattered goes back: E = s (1 - a), F = s.
                e[i * kTile + i][lane] = kExtinction[i] * (1 - kAlbedo[lane]);
                f[i * kTile + i][lane] = kExtinction[i];
            }
        }
        ImpedanceWorkspace work(kTile);
        slab_impedance(e.data(), f.data(), depth, doublings_for(depth), kTile, work);
        for (int i = 0; i < kTile; ++i) {
            for (int lane = 0; lane < kLanes; ++lane) {
                SCOPED_TRACE(testing::Message() << depth << ' ' << i << ' ' << kAlbedo[lane]);
                const double ratio = std::sqrt(1 - kAlbedo[lane]);
                const double half = 0.5 * depth * kExtinction[i] * ratio;
                const double zs = ratio * std::tanh(half);
                const double za =
                    ratio > 0 ? ratio / std::tanh(half) : 2 / (depth * kExtinction[i]);
                EXPECT_NEAR(e[i * kTile + i][lane], zs, kStartError * zs);
                EXPECT_NEAR(f[i * kTile + i][lane], za, kStartError * za);
                ++cases;
            }
        }
    }
    EXPECT_EQ(cases, 15 * kTile * kLanes);
}

TEST(Impedance, SlabsAreTheMatrixTanhAndCoth) {
    const Medium m = random_medium(12, 0.05, 7);
    for (double thickness : {1e-6, 1e-2, 0.3, 1.0, 10.0, 1e3}) {
        const Slab s = slab(m, thickness);
        const Matrices zs = test::from_lanes(s.zs, 12, 12), za = test::from_lanes(s.za, 12, 12);
        for (int lane = 0; lane < kLanes; ++lane) {
            SCOPED_TRACE(testing::Message() << thickness << " lane " << lane);
            const MatrixXd tanh = closed_form(m.e[lane], m.f[lane], thickness, true);
            const MatrixXd coth = closed_form(m.e[lane], m.f[lane], thickness, false);
            // The relative error of each mode bounds that of the norm, up to the conditioning of
            // the change of basis.
            EXPECT_LT((zs[lane] - tanh).norm(), 2 * kStartError * tanh.norm());
            EXPECT_LT((za[lane] - coth).norm(), 2 * kStartError * coth.norm());
        }
    }
}

TEST(Impedance, ThickSlabsReachTheGeometricMean) {
    // Z_s = Z_a = F^-1 # E for the half space: Z F Z = E.
    const Medium m = random_medium(8, 0.1, 11);
    const Slab s = slab(m, 1e5);
    const Matrices zs = test::from_lanes(s.zs, 8, 8), za = test::from_lanes(s.za, 8, 8);
    for (int lane = 0; lane < kLanes; ++lane) {
        // Deep modes start up to 3e-8 of their depth and reach the limit quadratically: rounding.
        EXPECT_LT((zs[lane] - za[lane]).norm(), 1e-10 * za[lane].norm());
        EXPECT_LT((zs[lane] * m.f[lane] * zs[lane] - m.e[lane]).norm(), 1e-10 * m.e[lane].norm());
    }
}

TEST(Impedance, DoublingIsStackingTwoHalves) {
    const Medium m = random_medium(8, 0.02, 13);
    const double thickness = 0.8;
    const int doublings = doublings_for(thickness * m.deepest);
    const Slab whole = slab(m, thickness, doublings + 1), half = slab(m, thickness / 2, doublings);
    const Matrices zs = test::from_lanes(whole.zs, 8, 8), za = test::from_lanes(whole.za, 8, 8);
    const Matrices hs = test::from_lanes(half.zs, 8, 8), ha = test::from_lanes(half.za, 8, 8);
    for (int lane = 0; lane < kLanes; ++lane) {
        // R and T of the half, then the classic doubling.
        const MatrixXd one = MatrixXd::Identity(8, 8);
        const MatrixXd r = 0.5 * (reflection(hs[lane]) + reflection(ha[lane]));
        const MatrixXd t = 0.5 * (reflection(hs[lane]) - reflection(ha[lane]));
        const MatrixXd t_between = test::product(t, test::inverse(one - test::product(r, r)));
        const MatrixXd r2 = r + test::product(t_between, test::product(r, t)),
                       t2 = test::product(t_between, t);
        // Algebraically the same: rounding only.
        EXPECT_LT((0.5 * (reflection(zs[lane]) + reflection(za[lane])) - r2).norm(), 1e-12);
        EXPECT_LT((0.5 * (reflection(zs[lane]) - reflection(za[lane])) - t2).norm(), 1e-12);
    }
}

TEST(Impedance, StackingIsTheStarProduct) {
    const int n = 8;
    const Medium top = random_medium(n, 0.1, 17), bottom = random_medium(n, 0.3, 19);
    Slab s = slab(top, 0.4);
    const Slab base = slab(bottom, 2.0);
    const Matrices zs = test::from_lanes(s.zs, n, n), za = test::from_lanes(s.za, n, n);
    const Matrices y0 = test::from_lanes(base.zs, n, n);  // any positive impedance will do
    LaneBuffer y = base.zs;
    ImpedanceWorkspace work(n);
    stack_on(s.zs.data(), s.za.data(), y.data(), n, work);
    impedance_to_reflection(y.data(), n, work);
    const Matrices found = test::from_lanes(y, n, n);
    for (int lane = 0; lane < kLanes; ++lane) {
        const MatrixXd one = MatrixXd::Identity(n, n);
        const MatrixXd r = 0.5 * (reflection(zs[lane]) + reflection(za[lane]));
        const MatrixXd t = 0.5 * (reflection(zs[lane]) - reflection(za[lane]));
        const MatrixXd r0 = reflection(y0[lane]);
        const MatrixXd between = test::inverse(one - test::product(r0, r));
        const MatrixXd expected =
            r + test::product(test::product(t, between), test::product(r0, t));
        EXPECT_LT((found[lane] - expected).norm(), 1e-12) << lane;  // rounding
    }
}

TEST(Impedance, WithoutAbsorptionFluxIsKeptAtAnyThickness) {
    const int n = 12;
    const Medium m = random_medium(n, 0.0, 23);
    for (double thickness : {1e-8, 1e-3, 1.0, 1e2, 1e6}) {
        const Slab s = slab(m, thickness);
        const Matrices zs = test::from_lanes(s.zs, n, n), za = test::from_lanes(s.za, n, n);
        for (int lane = 0; lane < kLanes; ++lane) {
            const VectorXd flux = m.flux.col(lane);
            // R + T = (1 + Z_s)^-1 (1 - Z_s) leaves the flux vector alone. E times it rounds at
            // 1e-16 of the diagonal, and thickness amplifies that: 1e6 x 1e-16 x n.
            const VectorXd kept = reflection(zs[lane]) * flux;
            EXPECT_LT((kept - flux).norm(), (1e-13 + 3e-15 * thickness) * flux.norm())
                << thickness << " lane " << lane;
            // No eigenvalue of R +- T leaves [-1, 1]: no light is created.
            for (const MatrixXd& z : {zs[lane], za[lane]}) {
                const SymmetricEigen eigen = symmetric_eigen(reflection(z));
                EXPECT_LT(eigen.values.cwiseAbs().maxCoeff(), 1 + 1e-13 + 3e-15 * thickness);
            }
        }
    }
}

TEST(Impedance, ReflectsUnderAnInterface) {
    const int n = 12, rows = 8;
    const Medium m = random_medium(n, 0.05, 29);
    Slab s = slab(m, 3.0);
    ImpedanceWorkspace work(n);
    LaneBuffer r = s.zs, u(rows * rows), interface_reflectance;
    impedance_to_reflection(r.data(), n, work);
    for (int i = 0; i < n; ++i) {
        interface_reflectance.push_back(make_lanes<DoubleLanes>(
            [&](int lane) { return i < rows ? 0.04 + 0.1 * i + 0.01 * lane : 1.0; }));
    }
    const Matrices below = test::from_lanes(r, n, n);
    reflect_under_interface(s.zs.data(), interface_reflectance.data(), u.data(), n, rows, work);
    const Matrices found = test::from_lanes(u, rows, rows);
    for (int lane = 0; lane < kLanes; ++lane) {
        VectorXd f(n);
        for (int i = 0; i < n; ++i) f(i) = interface_reflectance[i][lane];
        const MatrixXd one = MatrixXd::Identity(n, n);
        const MatrixXd expected =
            test::product(test::inverse(one - below[lane] * f.asDiagonal()), below[lane]);
        EXPECT_LT((found[lane] - expected.topLeftCorner(rows, rows)).norm(), 1e-12) << lane;
    }
}

TEST(Impedance, DoublingsGrowWithTheSquareRootOfDepthOnly) {
    EXPECT_EQ(doublings_for(1e-8), 0);
    EXPECT_EQ(doublings_for(0.75), 0);  // x = 0.375
    EXPECT_EQ(doublings_for(0.76), 1);
    EXPECT_EQ(doublings_for(10), 3);
    EXPECT_EQ(doublings_for(1e6), 11);  // 4^11 = 4.2e6 >= 1.33e6
    EXPECT_EQ(doublings_for(0), 0);
}

}  // namespace
}  // namespace nacre::solver
