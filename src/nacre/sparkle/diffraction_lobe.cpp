#include "nacre/sparkle/diffraction_lobe.h"

#include <array>

#include "nacre/core/error.h"
#include "nacre/core/quadrature.h"

namespace nacre::sparkle {
namespace {

// Tables over slope^2/alpha^2 in [0, kMaxSquare] and y = width/alpha in [0, kMaxWidth].
constexpr int kSquareNodes = DiffractionLobe::kSquareNodes,
              kWidthNodes = DiffractionLobe::kWidthNodes;
constexpr float kMaxSquare = DiffractionLobe::kMaxExponent, kMaxWidth = DiffractionLobe::kMaxWidth;
using Table = std::array<float, kSquareNodes * kWidthNodes>;

// Row(y)(slope/alpha) at the nodes.
template <class Row>
Table tabulate() {
    Table table;
    for (int i = 0; i < kWidthNodes; ++i) {
        const Row row(kMaxWidth * i / (kWidthNodes - 1.0));
        for (int j = 0; j < kSquareNodes; ++j) {
            const double square = kMaxSquare * j / (kSquareNodes - 1.0);
            table[i * kSquareNodes + j] = static_cast<float>(row(std::sqrt(square)));
        }
    }
    return table;
}

float look_up(const Table& table, float square, float y) {
    constexpr float kSquareScale = (kSquareNodes - 1) / kMaxSquare;
    constexpr float kWidthScale = (kWidthNodes - 1) / kMaxWidth;
    const float a = std::min(y * kWidthScale, kWidthNodes - 1.001f);
    const float b = std::min(square * kSquareScale, kSquareNodes - 1.001f);
    const int i = static_cast<int>(a), j = static_cast<int>(b);
    const float fa = a - i, fb = b - j;
    const float* p = table.data() + i * kSquareNodes + j;
    const float low = p[0] + fb * (p[1] - p[0]);
    const float high = p[kSquareNodes] + fb * (p[kSquareNodes + 1] - p[kSquareNodes]);
    return low + fa * (high - low);
}

// log(blur)/y^2 for K, nearly linear in x^2 and y: blur = 1 + (x^2 - 1) y^2/4 + ...
//
// The blur, (P * K) / P at the slope x alpha, is with u the square of the distance over r^2
//     Int_0^1 3 (1 - u)^2 exp(-u y^2) I_0(2 x y sqrt(u)) du
// and I_0(2 sqrt(z)) = Sum_k z^k / k!^2, whose terms are all positive.
class LogBlurOverY2 {
 public:
    explicit LogBlurOverY2(double y) : y_(y) {
        const Quadrature& rule = unit_gauss_legendre(64);
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
            const double t = rule.nodes[i];
            double term = rule.weights[i] * 3 * (1 - t) * (1 - t) * std::exp(-t * y * y);
            for (int k = 0; k < kTerms; ++k) {
                series_[k] += term;
                term *= t * y * y / ((k + 1.0) * (k + 1.0));
            }
        }
    }
    double operator()(double x) const {
        if (y_ == 0) return 0.25 * (x * x - 1);
        double sum = 0;
        for (int k = kTerms; k-- > 0;) sum = sum * x * x + series_[k];
        return std::log(sum) / (y_ * y_);
    }

 private:
    static constexpr int kTerms = 60;  // the rest is below e^-80 of the sum for x^2 y^2 = 224
    double y_;
    std::array<double, kTerms> series_{};
};

const Table& log_blur_over_y2() {
    static const Table table = tabulate<LogBlurOverY2>();
    return table;
}

// 1/e_h, the blur by the Airy pattern over e times that by K, nearly linear in y; the
// rings alone grow with e^(x^2).
//
// The former by Hankel transforms: that of the pattern is the overlap of two discs,
// O(s) = 2/pi (acos s - s sqrt(1 - s^2)) at the frequency s d/lambda', that of P a Gaussian.
//                                                          [born-wolf-1999, sections 8.5.2 and 9.5]
class InverseLobeFraction {
 public:
    explicit InverseLobeFraction(double y) : y_(y) {
        if (y == 0) return;
        const Quadrature& rule = unit_gauss_legendre(kNodes);
        const double cutoff = std::numbers::pi * DiffractionLobe::kLobeRadius / y;  // s = 1
        const double end = std::min(cutoff, 7.0);                                   // e^-49
        for (int i = 0; i < kNodes; ++i) {
            const double t = end * rule.nodes[i], s = t / cutoff;
            frequencies_[i] = t;
            weights_[i] = end * rule.weights[i] * 2 * t * std::exp(-t * t) * 2 *
                          std::numbers::inv_pi * (std::acos(s) - s * std::sqrt(1 - s * s));
        }
    }
    double operator()(double x) const {
        const double e = DiffractionLobe::kLobePower;
        if (y_ == 0) return 1 / e;
        double sum = 0;
        for (int i = 0; i < kNodes; ++i) sum += weights_[i] * ::j0(2 * x * frequencies_[i]);
        const double log_blur =
            y_ * y_ *
            look_up(log_blur_over_y2(), static_cast<float>(x * x), static_cast<float>(y_));
        return sum * std::exp(x * x - log_blur) / e;
    }

 private:
    static constexpr int kNodes = 48;
    double y_;
    std::array<double, kNodes> frequencies_{}, weights_{};
};

const Table& inverse_lobe_fraction() {
    static const Table table = tabulate<InverseLobeFraction>();
    return table;
}

}  // namespace

DiffractionLobe::DiffractionLobe(double alpha, double ior, double coat_roughness, double waviness) {
    require_in_range(alpha, 1e-3, 1, "roughness alpha of the flakes");
    require_in_range(ior, 1, 3, "refractive index of the binder");
    require_in_range(coat_roughness, 0, 1, "roughness of the clearcoat");
    require_in_range(waviness, 0, 2 * alpha * (1 + 1e-9), "waviness of the flakes");
    coat_ = CoatTilt(coat_roughness, ior);
    waviness2_ = static_cast<float>(waviness * waviness);
    inverse_alpha2_ = static_cast<float>(1 / (alpha * alpha));
    norm_ = std::numbers::inv_pi_v<float> * inverse_alpha2_;
    inverse_alpha_ = static_cast<float>(1 / alpha);
    max_radius_ = static_cast<float>(kMaxWidth * alpha);
    // Half, as the half vector turns by half; |q| = 2 (w_i.h) |h - m|.
    radius_um_ = static_cast<float>(0.5 * kLobeRadius * kWavelength_um / ior);
    // The tables are made now, as queries allocate nothing.
    log_blur_over_y2();
    inverse_lobe_fraction();
}

std::span<const float> DiffractionLobe::log_blur_table() { return log_blur_over_y2(); }

std::span<const float> DiffractionLobe::inverse_lobe_fraction_table() {
    return sparkle::inverse_lobe_fraction();
}

float DiffractionLobe::blur(float slope2, float width) const {
    static const Table& table = log_blur_over_y2();
    const float y = width * inverse_alpha_;
    return std::exp(y * y * look_up(table, slope2 * inverse_alpha2_, y));
}

float DiffractionLobe::lobe_fraction(float exponent, float width_over_alpha, float power) {
    static const Table& table = inverse_lobe_fraction();
    return 1 / std::max(1.0f, kLobePower / power * look_up(table, exponent, width_over_alpha));
}

}  // namespace nacre::sparkle
