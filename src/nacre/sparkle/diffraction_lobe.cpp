#include "nacre/sparkle/diffraction_lobe.h"

#include "nacre/core/error.h"
#include "nacre/core/quadrature.h"

namespace nacre::sparkle {
namespace {

// The blur is tabulated as  log(blur) / y^2  over slope^2/alpha^2 in [0, kMaxSquare] and
// y = width/alpha in [0, kMaxWidth]: nearly linear in both, as blur = 1 + (x^2 - 1) y^2/4 + ...
constexpr int kSquareNodes = 65, kWidthNodes = 65;
constexpr float kMaxSquare = DiffractionLobe::kMaxExponent, kMaxWidth = 4;

// Int_0^1 3 (1 - t)^2 exp(-t y^2) I_0(2 x y sqrt(t)) dt: the integral over the circle of
// K(s) P(p - s) / P(p), with t = s^2/w^2.
double blur_of(double x, double y) {
    static const Quadrature rule = gauss_legendre(64, 0.0, 1.0);
    double sum = 0;
    for (std::size_t i = 0; i < rule.nodes.size(); ++i) {
        // sqrt(t) as the variable: the integrand is entire in it.
        const double root = rule.nodes[i], t = root * root;
        sum += rule.weights[i] * 2 * root * 3 * (1 - t) * (1 - t) * std::exp(-t * y * y) *
               std::cyl_bessel_i(0.0, 2 * x * y * root);
    }
    return sum;
}

std::shared_ptr<const std::vector<float>> blur_table() {
    static const auto table = [] {
        auto values = std::make_shared<std::vector<float>>();
        for (int i = 0; i < kWidthNodes; ++i) {
            const double y = kMaxWidth * i / (kWidthNodes - 1.0);
            for (int j = 0; j < kSquareNodes; ++j) {
                const double square = kMaxSquare * j / (kSquareNodes - 1.0);
                values->push_back(
                    static_cast<float>(i == 0 ? 0.25 * (square - 1)
                                              : std::log(blur_of(std::sqrt(square), y)) / (y * y)));
            }
        }
        return values;
    }();
    return table;
}

}  // namespace

DiffractionLobe::DiffractionLobe(double alpha, double ior) {
    require_in_range(alpha, 1e-3, 1, "roughness alpha of the flakes");
    require_in_range(ior, 1, 3, "refractive index of the binder");
    inverse_alpha2_ = static_cast<float>(1 / (alpha * alpha));
    norm_ = std::numbers::inv_pi_v<float> * inverse_alpha2_;
    inverse_alpha_ = static_cast<float>(1 / alpha);
    max_radius_ = static_cast<float>(kMaxWidth * alpha);
    // Half, as the half vector turns by half; |q| = 2 (w_i.h) |h - m|.
    radius_um_ = static_cast<float>(0.5 * kAiryRadius * kWavelength_um / ior);
    blur_table_ = blur_table();
}

float DiffractionLobe::blur(float slope2, float width) const {
    constexpr float kSquareScale = (kSquareNodes - 1) / kMaxSquare;
    constexpr float kWidthScale = (kWidthNodes - 1) / kMaxWidth;
    const float y = width * inverse_alpha_;
    const float a = std::min(y * kWidthScale, kWidthNodes - 1.001f);
    const float b = std::min(slope2 * inverse_alpha2_ * kSquareScale, kSquareNodes - 1.001f);
    const int i = static_cast<int>(a), j = static_cast<int>(b);
    const float fa = a - i, fb = b - j;
    const float* p = blur_table_->data() + i * kSquareNodes + j;
    const float low = p[0] + fb * (p[1] - p[0]);
    const float high = p[kSquareNodes] + fb * (p[kSquareNodes + 1] - p[kSquareNodes]);
    return std::exp(y * y * (low + fa * (high - low)));
}

}  // namespace nacre::sparkle
