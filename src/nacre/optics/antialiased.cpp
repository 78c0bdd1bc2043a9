#include "nacre/optics/antialiased.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/spectra/colour.h"
#include "nacre/spectra/rgb.h"

namespace nacre::optics {
namespace {

using Complex = std::complex<double>;
using RgbWave = std::array<Complex, 3>;

constexpr double kTwoPi = 2 * std::numbers::pi;

const Vec3d& white_xyz() {
    static const Vec3d white = spectra::linear_rec709_to_xyz({1, 1, 1});
    return white;
}

// Weights of R(lambda) in its colour, rgb = sum weights[i] R(wavelengths_nm[i]), every `step_nm`
// over 360-780 nm.
struct ColourSums {
    std::vector<double> wavelengths_nm;
    std::vector<Vec3d> weights;

    explicit ColourSums(int step_nm) {
        using namespace spectra;
        Vec3d sum{};
        for (int nm = 360; nm <= 780; nm += step_nm) {
            Vec3d xyz = colour_matching(Observer::cie1931_2deg, nm);
            for (int c = 0; c < 3; ++c) {
                xyz[c] *= illuminant_power(Illuminant::D65, nm);
                sum[c] += xyz[c];
            }
            wavelengths_nm.push_back(nm);
            weights.push_back(xyz);
        }
        for (Vec3d& w : weights) {
            for (int c = 0; c < 3; ++c) w[c] *= white_xyz()[c] / sum[c];
            w = xyz_to_linear_rec709(w);
        }
    }

    static const ColourSums& at(int step_nm) {
        static const ColourSums fine(1), medium(5), coarse(10);
        switch (step_nm) {
            case 1:
                return fine;
            case 5:
                return medium;
            case 10:
                return coarse;
            default:
                throw DomainError(fmt::format("step = {} nm: must be 1, 5 or 10", step_nm));
        }
    }
};

// The phase of the transform advances about as that of a wave of 540 nm. Without this carrier it is
// smooth, so that cubic Hermite interpolation every 25 nm keeps kTransformError.
class TransformTable {
 public:
    static constexpr double kStep_nm = 25, kCarrier_per_nm = 1 / 540.0;

    TransformTable() {
        const ColourSums& sums = ColourSums::at(1);
        const auto count = static_cast<std::size_t>(kTransformReach_nm / kStep_nm) + 1;
        knots_.resize(count);
        for (std::size_t w = 0; w < sums.weights.size(); ++w) {
            const double k = kTwoPi * (1 / sums.wavelengths_nm[w] - kCarrier_per_nm);
            const Complex turn = std::polar(1.0, k * kStep_nm);
            Complex wave = 1;
            for (std::size_t n = 0; n < count; ++n, wave *= turn) {
                const Complex slope = wave * Complex(0, k * kStep_nm);
                for (int c = 0; c < 3; ++c) {
                    knots_[n].value[c] += sums.weights[w][c] * wave;
                    knots_[n].slope[c] += sums.weights[w][c] * slope;
                }
            }
        }
    }

    RgbWave operator()(double path_nm) const {
        const double x = path_nm / kStep_nm;
        if (!(x < static_cast<double>(knots_.size() - 1))) return {};
        const auto n = static_cast<std::size_t>(x);
        const double t = x - static_cast<double>(n), u = 1 - t;
        const Complex carrier = std::polar(1.0, kTwoPi * kCarrier_per_nm * path_nm);
        RgbWave s;
        for (int c = 0; c < 3; ++c) {
            s[c] = carrier *
                   (u * u * ((1 + 2 * t) * knots_[n].value[c] + t * knots_[n].slope[c]) +
                    t * t * ((1 + 2 * u) * knots_[n + 1].value[c] - u * knots_[n + 1].slope[c]));
        }
        return s;
    }

 private:
    struct Knot {
        RgbWave value{}, slope{};
    };
    std::vector<Knot> knots_;
};

// Belcour & Barla's Gaussians in wave number by the numbers of their supplement: height, centre and
// `var`, which is half of the variance. X has two lobes.
RgbWave paper_transform(double path_nm) {
    struct Gaussian {
        int channel;
        double height, centre_per_m, var_per_m2;
        double area() const { return height * std::sqrt(kTwoPi * var_per_m2); }
    };
    static constexpr Gaussian kLobes[] = {{0, 5.4856e-13, 1.6810e6, 4.3278e9},
                                          {1, 4.4201e-13, 1.7953e6, 9.3046e9},
                                          {2, 5.2481e-13, 2.2084e6, 6.6121e9},
                                          {0, 9.7470e-14, 2.2399e6, 4.5282e9}};
    static const Vec3d total = [] {
        Vec3d sum{};
        for (const Gaussian& g : kLobes) sum[g.channel] += g.area();
        return sum;
    }();
    const double phase = kTwoPi * path_nm * 1e-9;
    Vec3d re{}, im{};
    for (const Gaussian& g : kLobes) {
        const double size = g.area() / total[g.channel] * white_xyz()[g.channel] *
                            std::exp(-phase * phase * g.var_per_m2);
        re[g.channel] += size * std::cos(phase * g.centre_per_m);
        im[g.channel] += size * std::sin(phase * g.centre_per_m);
    }
    re = spectra::xyz_to_linear_rec709(re);
    im = spectra::xyz_to_linear_rec709(im);
    return {Complex(re[0], im[0]), Complex(re[1], im[1]), Complex(re[2], im[2])};
}

}  // namespace

std::array<Complex, 3> observer_transform(ObserverTransform transform, double optical_path_nm) {
    if (transform == ObserverTransform::paper) return paper_transform(optical_path_nm);
    static const TransformTable table;
    return table(optical_path_nm);
}

Vec3d antialiased_rgb(const AiryFilm& film, double cosine, double thickness_nm,
                      const Antialiasing& how) {
    const auto terms = film.terms(cosine);
    if (!terms) return integrated_rgb(film, cosine, thickness_nm, 5);

    constexpr double kNegligible = 1e-6;
    const double path_nm = terms->optical_path_per_thickness * thickness_nm;
    const Complex step_s = std::polar(terms->s.ratio, terms->s.phase);
    const Complex step_p = std::polar(terms->p.ratio, terms->p.phase);
    const double c0 = (terms->s.c0 + terms->p.c0) / 2;
    Vec3d rgb{c0, c0, c0};
    Complex s = terms->s.strength * step_s, p = terms->p.strength * step_p;
    for (int m = 1; m <= how.orders; ++m, s *= step_s, p *= step_p) {
        // This and all higher orders sum to at most |s| / (1 - ratio).
        if (std::abs(s) < kNegligible * (1 - terms->s.ratio) &&
            std::abs(p) < kNegligible * (1 - terms->p.ratio)) {
            break;
        }
        if (m * path_nm > kTransformReach_nm) break;
        const RgbWave transform = observer_transform(how.transform, m * path_nm);
        for (int c = 0; c < 3; ++c) rgb[c] += ((s + p) * transform[c]).real();
    }
    return rgb;
}

Vec3d integrated_rgb(const AiryFilm& film, double cosine, double thickness_nm, int step_nm) {
    const ColourSums& sums = ColourSums::at(step_nm);
    const auto angle = film.at<double>(cosine);
    Vec3d rgb{};
    const std::size_t count = sums.weights.size();
    for (std::size_t w = 0; w < count; w += kLanes) {
        const DoubleLanes R = angle.reflectance(make_lanes<DoubleLanes>(
            [&](int i) { return thickness_nm / sums.wavelengths_nm[std::min(w + i, count - 1)]; }));
        for (std::size_t i = 0; i < kLanes && w + i < count; ++i) {
            for (int c = 0; c < 3; ++c) rgb[c] += sums.weights[w + i][c] * R[i];
        }
    }
    return rgb;
}

AntialiasingComparison compare_antialiasing(const AiryFilm& film, double cosine,
                                            double thickness_nm, const Antialiasing& how) {
    using namespace spectra;
    AntialiasingComparison c{antialiased_rgb(film, cosine, thickness_nm, how),
                             integrated_rgb(film, cosine, thickness_nm), 0, 0};
    c.delta_e = delta_e_2000(linear_rec709_to_lab(c.rgb), linear_rec709_to_lab(c.integrated_rgb));
    for (int i = 0; i < 3; ++i) {
        c.rgb_error = std::max(c.rgb_error, std::abs(c.rgb[i] - c.integrated_rgb[i]));
    }
    return c;
}

AntialiasingError antialiasing_error(const AiryFilm& film, std::span<const double> cosines,
                                     std::span<const double> thicknesses_nm,
                                     const Antialiasing& how) {
    if (cosines.empty() || thicknesses_nm.empty()) {
        throw DomainError("the error of antialiasing needs at least one angle and one thickness");
    }
    AntialiasingError error;
    for (const double cosine : cosines) {
        for (const double thickness_nm : thicknesses_nm) {
            const auto c = compare_antialiasing(film, cosine, thickness_nm, how);
            error.mean_delta_e += c.delta_e;
            error.max_delta_e = std::max(error.max_delta_e, c.delta_e);
            error.mean_rgb += c.rgb_error;
            error.max_rgb = std::max(error.max_rgb, c.rgb_error);
        }
    }
    const auto count = static_cast<double>(cosines.size() * thicknesses_nm.size());
    error.mean_delta_e /= count;
    error.mean_rgb /= count;
    return error;
}

}  // namespace nacre::optics
