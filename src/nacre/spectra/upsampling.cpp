#include "nacre/spectra/upsampling.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nacre/core/error.h"
#include "nacre/core/math.h"
#include "nacre/spectra/rgb.h"

namespace nacre::spectra {
namespace {

constexpr double kFirst_nm = 360, kStep_nm = 10;
constexpr int kSamples = 43;  // to 780 nm, where the table of D65 ends
using Samples = std::array<double, kSamples>;

// Linear Rec. 709 = sum over samples of weights * rho, the white being (1, 1, 1).
struct ColourWeights {
    std::array<Samples, 3> rgb;  // by channel
};

ColourWeights make_colour_weights() {
    std::vector<double> wavelengths_nm;
    for (int i = 0; i < kSamples; ++i) wavelengths_nm.push_back(kFirst_nm + i * kStep_nm);
    const std::vector<Vec3d> by_sample = rec709_weights(wavelengths_nm);
    ColourWeights weights;
    for (int i = 0; i < kSamples; ++i) {
        for (int c = 0; c < 3; ++c) weights.rgb[c][i] = by_sample[i][c];
    }
    return weights;
}

// Solves T x = b for a tridiagonal T and several right sides b at once, which x replaces.
// Gaussian elimination exchanging neighbouring rows for the larger pivot, since T may be
// indefinite; the exchange fills a second upper diagonal.
template <std::size_t columns>
void solve_tridiagonal(Samples lower, Samples diagonal, Samples upper,
                       std::array<std::array<double, columns>, kSamples>& b) {
    Samples second{};
    for (int i = 0; i + 1 < kSamples; ++i) {
        if (std::abs(lower[i]) > std::abs(diagonal[i])) {
            std::swap(diagonal[i], lower[i]);
            std::swap(upper[i], diagonal[i + 1]);
            if (i + 2 < kSamples) std::swap(second[i], upper[i + 1]);
            std::swap(b[i], b[i + 1]);
        }
        const double factor = lower[i] / diagonal[i];
        diagonal[i + 1] -= factor * upper[i];
        if (i + 2 < kSamples) upper[i + 1] -= factor * second[i];
        for (std::size_t c = 0; c < columns; ++c) b[i + 1][c] -= factor * b[i][c];
    }
    for (int i = kSamples - 1; i >= 0; --i) {
        for (std::size_t c = 0; c < columns; ++c) {
            if (i + 1 < kSamples) b[i][c] -= upper[i] * b[i + 1][c];
            if (i + 2 < kSamples) b[i][c] -= second[i] * b[i + 2][c];
            b[i][c] /= diagonal[i];
        }
    }
}

// Cramer's rule.
Vec3d solve_3x3(const std::array<Vec3d, 3>& columns, const Vec3d& b) {
    const auto det = [](const Vec3d& u, const Vec3d& v, const Vec3d& w) {
        return u[0] * (v[1] * w[2] - v[2] * w[1]) - v[0] * (u[1] * w[2] - u[2] * w[1]) +
               w[0] * (u[1] * v[2] - u[2] * v[1]);
    };
    const auto& [u, v, w] = columns;
    const double d = det(u, v, w);
    return {det(b, v, w) / d, det(u, b, w) / d, det(u, v, b) / d};
}

// Least slope squared of z = artanh(2 rho - 1) under the condition that the colour is met, by
// Newton's method on Lagrange's equations                                        [burns-2020]
//   sum_j D_ij z_j + kRidge (z_i - z0) + rho'(z_i) (lambda . T_i) = 0,     T rho(z) = rgb,
// where D is twice the second difference and T holds the colour weights. The ridge, too weak to
// show, makes the matrix regular where lambda = 0.
class LeastSlope {
 public:
    explicit LeastSlope(const Vec3d& rgb) : rgb_(rgb) {
        const double luminance = std::clamp(linear_rec709_to_xyz(rgb)[1], 1e-4, 1 - 1e-4);
        z0_ = std::atanh(2 * luminance - 1);
        grey_ = {luminance, luminance, luminance};
    }

    /// Newton's method converges for most colours from the grey of the same luminance. Where it
    /// does not, colours in between are solved first: the stride doubles after success and halves
    /// after failure.
    /// @throws Error if that fails too, which has not been seen
    Samples solve() {
        State start;  // solves the equations for the grey
        start.z.fill(z0_);
        double reached = 0, stride = 1;
        while (reached < 1) {
            const double aim = std::min(1.0, reached + stride);
            for (int c = 0; c < 3; ++c) target_[c] = std::lerp(grey_[c], rgb_[c], aim);
            at_ = start;
            evaluate(at_);
            if (newton()) {
                start = at_;
                reached = aim;
                stride *= 2;
            } else if ((stride /= 2) < kMinStride) {
                throw Error(
                    fmt::format("no smooth reflectance was found for linear RGB "
                                "({}, {}, {})",
                                rgb_[0], rgb_[1], rgb_[2]));
            }
        }
        return at_.rho;
    }

 private:
    static constexpr double kRidge = 1e-6;
    static constexpr int kMaxIterations = 30;
    static constexpr double kMinStride = 1e-4;

    struct State {
        Samples z{}, rho{}, slope{}, gradient{};  // slope = d rho / dz
        Vec3d lambda{}, miss{};                   // miss = colour - target
        double merit = 0;
    };

    const ColourWeights& weights() const {
        static const ColourWeights weights = make_colour_weights();
        return weights;
    }
    double pull(const State& s, int i) const {
        const auto& w = weights().rgb;
        return s.lambda[0] * w[0][i] + s.lambda[1] * w[1][i] + s.lambda[2] * w[2][i];
    }

    void evaluate(State& s) const {
        s.merit = 0;
        s.miss = {-target_[0], -target_[1], -target_[2]};
        for (int i = 0; i < kSamples; ++i) {
            s.rho[i] = 1 / (1 + std::exp(-2 * s.z[i]));
            s.slope[i] = 2 * s.rho[i] * (1 - s.rho[i]);
            const double left = i > 0 ? s.z[i] - s.z[i - 1] : 0;
            const double right = i + 1 < kSamples ? s.z[i + 1] - s.z[i] : 0;
            s.gradient[i] = 2 * (left - right) + kRidge * (s.z[i] - z0_) + s.slope[i] * pull(s, i);
            s.merit += square(s.gradient[i]);
            for (int c = 0; c < 3; ++c) s.miss[c] += weights().rgb[c][i] * s.rho[i];
        }
        // Both residuals must vanish; the colour counts more, so that it is met before the
        // slope is polished.
        for (int c = 0; c < 3; ++c) s.merit += 1e4 * s.miss[c] * s.miss[c];
    }

    bool converged() const {
        const auto below = [](double bound) {
            return [bound](double x) { return std::abs(x) < bound; };
        };
        const std::array miss{at_.miss.x, at_.miss.y, at_.miss.z};
        return std::all_of(miss.begin(), miss.end(), below(kUpsamplingError / 10)) &&
               std::all_of(at_.gradient.begin(), at_.gradient.end(), below(1e-8));
    }

    bool newton() {
        for (int iteration = 0; iteration < kMaxIterations; ++iteration) {
            if (converged()) return true;
            if (!step()) return false;
        }
        return false;
    }

    // Newton's matrix is bordered, [H B; B^T 0] with H tridiagonal: eliminate z, solve for lambda.
    // False if no step in the direction found leads closer to a solution.
    bool step() {
        Samples off, diagonal;
        off.fill(-2);
        std::array<std::array<double, 4>, kSamples> x;  // H^-1 times B and the gradient
        for (int i = 0; i < kSamples; ++i) {
            const double curvature = 2 * at_.slope[i] * (1 - 2 * at_.rho[i]);
            diagonal[i] = (i == 0 || i == kSamples - 1 ? 2 : 4) + kRidge + curvature * pull(at_, i);
            for (int c = 0; c < 3; ++c) x[i][c] = at_.slope[i] * weights().rgb[c][i];
            x[i][3] = at_.gradient[i];
        }
        const auto border = x;
        solve_tridiagonal(off, diagonal, off, x);
        std::array<Vec3d, 3> schur{};
        Vec3d right = at_.miss;
        for (int i = 0; i < kSamples; ++i) {
            for (int c = 0; c < 3; ++c) {
                for (int d = 0; d < 3; ++d) schur[d][c] += border[i][c] * x[i][d];
                right[c] -= border[i][c] * x[i][3];
            }
        }
        const Vec3d dlambda = solve_3x3(schur, right);
        Samples dz;
        double largest = 0;
        for (int i = 0; i < kSamples; ++i) {
            dz[i] = -x[i][3] - x[i][0] * dlambda[0] - x[i][1] * dlambda[1] - x[i][2] * dlambda[2];
            largest = std::max(largest, std::abs(dz[i]));
        }
        // At most 2 in z, over which rho covers most of [0, 1]; then halved until the merit falls.
        // Written so that NaN counts as no fall.
        for (double t = largest > 2 ? 2 / largest : 1; t > 1e-3; t /= 2) {
            State next = at_;
            for (int i = 0; i < kSamples; ++i) next.z[i] += t * dz[i];
            for (int c = 0; c < 3; ++c) next.lambda[c] += t * dlambda[c];
            evaluate(next);
            if (next.merit < at_.merit) {
                at_ = next;
                return true;
            }
        }
        return false;
    }

    Vec3d rgb_, grey_, target_{};
    double z0_;
    State at_;
};

// LeastSlope takes colours with a component of at least kDarkest and one of at most 1 - kDarkest.
constexpr double kDarkest = 1e-3;

Samples solve_scaled(const Vec3d& rgb) {
    const double brightest = std::max({rgb.x, rgb.y, rgb.z});
    if (brightest >= kDarkest) return LeastSlope(rgb).solve();
    // Near black z tends to -infinity: solve a lighter colour of the same ratios and scale it.
    Vec3d lighter;
    for (int c = 0; c < 3; ++c) lighter[c] = rgb[c] / brightest * kDarkest;
    Samples rho = LeastSlope(lighter).solve();
    for (double& r : rho) r *= brightest / kDarkest;
    return rho;
}

}  // namespace

Spectrum reflectance_from_rec709(const Vec3d& linear_rgb) {
    for (int c = 0; c < 3; ++c) {
        const char* names[] = {"red", "green", "blue"};
        require_in_range(linear_rgb[c], 0, 1, names[c]);
    }
    const auto [low, high] = std::minmax({linear_rgb[0], linear_rgb[1], linear_rgb[2]});
    if (low == high) return Spectrum(low);

    // The method is symmetric under rho -> 1 - rho: near white, solve for the colour it lacks.
    const bool near_white = low > 1 - kDarkest;
    Vec3d rgb = linear_rgb;
    if (near_white) rgb = {1 - rgb[0], 1 - rgb[1], 1 - rgb[2]};
    const Samples rho = solve_scaled(rgb);

    std::vector<double> wavelengths_nm(kSamples), values(kSamples);
    for (int i = 0; i < kSamples; ++i) {
        wavelengths_nm[i] = kFirst_nm + i * kStep_nm;
        values[i] = near_white ? 1 - rho[i] : rho[i];
    }
    return Spectrum(std::move(wavelengths_nm), std::move(values));
}

}  // namespace nacre::spectra
