#include "apps/study/equal_time.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "nacre/core/error.h"
#include "nacre/io/image_difference.h"

namespace nacre::study {

double relative_square_error(const io::Image& picture, const io::Image& converged) {
    const io::Image difference =
        io::image_difference(picture, converged, "picture", "converged picture").picture;
    const std::vector<float> d = io::interleaved_rgb(difference, "difference"),
                             b = io::interleaved_rgb(converged, "converged picture");
    double sum = 0;
    for (std::size_t i = 0; i < d.size(); ++i) {
        const double relative = d[i] / (std::abs(b[i]) + io::ImageDifference::kDarkest);
        sum += relative * relative;
    }
    return sum / static_cast<double>(d.size());
}

double square_error_over_square_mean(const io::Image& picture, const io::Image& converged) {
    const double square =
        io::image_difference(picture, converged, "picture", "converged picture").mean_square_error;
    const std::vector<float> b = io::interleaved_rgb(converged, "converged picture");
    const double mean = std::accumulate(b.begin(), b.end(), 0.0) /
                        static_cast<double>(std::max<std::size_t>(b.size(), 1));
    if (!(mean > 0))
        throw InputError("converged picture: is black: errors cannot be relative to it");
    return square / (mean * mean);
}

std::optional<double> error_at(const ErrorCurve& curve, double seconds) {
    const std::vector<double>& t = curve.seconds;
    if (t.empty() || !(seconds >= t.front() && seconds <= t.back())) return std::nullopt;
    if (t.size() == 1) return curve.error[0];
    const auto above = std::upper_bound(t.begin() + 1, t.end() - 1, seconds);
    const auto i = static_cast<std::size_t>(above - t.begin());
    const double along = std::log(seconds / t[i - 1]) / std::log(t[i] / t[i - 1]);
    return curve.error[i - 1] * std::pow(curve.error[i] / curve.error[i - 1], along);
}

std::optional<double> seconds_at(const ErrorCurve& curve, double error) {
    const std::vector<double>& e = curve.error;
    if (e.empty() || e.front() < error) return std::nullopt;
    const auto below = std::find_if(e.begin(), e.end(), [&](double x) { return x <= error; });
    if (below == e.end()) return std::nullopt;
    const auto i = static_cast<std::size_t>(below - e.begin());
    if (i == 0) return curve.seconds[0];
    const double along = std::log(error / e[i - 1]) / std::log(e[i] / e[i - 1]);
    return curve.seconds[i - 1] * std::pow(curve.seconds[i] / curve.seconds[i - 1], along);
}

std::optional<double> equal_time_ratio(const ErrorCurve& a, const ErrorCurve& b) {
    if (a.seconds.empty() || b.seconds.empty()) return std::nullopt;
    const double first = std::max(a.seconds.front(), b.seconds.front());
    const double last = std::min(a.seconds.back(), b.seconds.back());
    if (!(first <= last)) return std::nullopt;
    constexpr int kSteps = 32;
    double sum = 0;
    for (int i = 0; i < kSteps; ++i) {
        // Clamped, as rounding may step beyond the ends.
        const double t =
            std::clamp(first * std::pow(last / first, i / (kSteps - 1.0)), first, last);
        sum += std::log(*error_at(a, t) / *error_at(b, t));
    }
    return std::exp(sum / kSteps);
}

}  // namespace nacre::study
