#include "apps/report/plot_frame.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "apps/report/plot_svg.h"

namespace nacre::report {

namespace {

// From here on, and below the second, numbers are written with powers of ten.
constexpr double kMaxPlain = 1e6, kMinPlain = 1e-3;
// A double has fifteen digits for certain: beyond this, neighbouring multiples look alike.
constexpr double kMaxIndex = 1e14;

std::string superscript(int exponent) {
    static constexpr const char* kDigits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text;
    for (const char c : std::to_string(exponent)) text += c == '-' ? "⁻" : kDigits[c - '0'];
    return text;
}

/// With the minus sign of typography.
std::string signed_text(std::string digits) {
    if (!digits.empty() && digits[0] == '-') digits.replace(0, 1, "−");
    return digits;
}

std::string scientific(double value, int decimals) {
    const std::string text = fmt::format("{:.{}e}", value, decimals);
    const std::size_t e = text.find('e');
    std::string digits = text.substr(0, e);
    if (digits.find('.') != std::string::npos) {
        while (digits.back() == '0') digits.pop_back();
        if (digits.back() == '.') digits.pop_back();
    }
    const std::string power = "10" + superscript(std::stoi(text.substr(e + 1)));
    if (digits == "1") return power;
    if (digits == "-1") return "−" + power;
    return signed_text(digits) + "·" + power;
}

int floor_log10(double value) { return static_cast<int>(std::floor(std::log10(value))); }

}  // namespace

double tick_step(double lo, double hi, double count) {
    const double raw = (hi - lo) / std::max(1.0, count);
    const double power = std::pow(10, floor_log10(raw));
    // Between two candidates the geometric mean decides.
    const double ratio = raw / power;
    const double digit = ratio >= std::sqrt(50)   ? 10
                         : ratio >= std::sqrt(10) ? 5
                         : ratio >= std::sqrt(2)  ? 2
                                                  : 1;
    return digit * power;
}

Extent rounded(const Extent& extent, double count) {
    if (!extent.round) return extent;
    Extent result = extent;
    const double step = tick_step(extent.lo, extent.hi, count);
    result.lo = step * std::floor(extent.lo / step);
    result.hi = step * std::ceil(extent.hi / step);
    return result.lo < result.hi ? result : extent;
}

std::string tick_text(double value, double step) {
    if (std::abs(value) < step * 1e-6) return "0";
    const int place = floor_log10(step * 1.000001);  // of the last digit that counts
    const double size = std::abs(value);
    if (size >= kMaxPlain || size < kMinPlain) {
        return scientific(value, std::clamp(floor_log10(size) - place, 0, 15));
    }
    return signed_text(fmt::format("{:.{}f}", value, std::clamp(-place, 0, 15)));
}

std::vector<Tick> linear_ticks(double lo, double hi, double count) {
    const double step = tick_step(lo, hi, count);
    // Ends that are multiples of the step but for rounding count.
    const double first = std::ceil(lo / step - 1e-9), last = std::floor(hi / step + 1e-9);
    std::vector<Tick> ticks;
    if (!(std::max(std::abs(first), std::abs(last)) < kMaxIndex)) return ticks;
    // One form for all numbers of an axis: with powers of ten if its largest needs them.
    const double largest = std::max(std::abs(first), std::abs(last)) * step;
    const bool plain = largest < kMaxPlain && largest >= kMinPlain;
    const int decimals = std::clamp(-floor_log10(step * 1.000001), 0, 15);
    for (double i = first; i <= last; ++i) {
        const double value = i * step;
        ticks.push_back(
            {value, plain ? signed_text(fmt::format("{:.{}f}", i == 0 ? 0 : value, decimals))
                          : tick_text(value, step)});
    }
    return ticks;
}

std::vector<Tick> logarithmic_ticks(double lo, double hi, double count) {
    const double decades = std::log10(hi) - std::log10(lo);
    if (decades < 1) return linear_ticks(lo, hi, count);
    // A reader counts in decades: each has its number even if they stand somewhat closer than
    // other ticks.
    const int every =
        decades <= 1.6 * count ? 1 : static_cast<int>(std::ceil(decades / std::max(1.0, count)));
    const bool numbered_2_and_5 = decades * 3 <= count * 1.5;
    std::vector<Tick> ticks;
    const auto add = [&](int exponent, int digit, bool numbered) {
        const double value = digit * std::pow(10, exponent);
        if (value < lo * (1 - 1e-12) || value > hi * (1 + 1e-12)) return;
        ticks.push_back({value, numbered ? tick_text(value, std::pow(10, exponent)) : ""});
    };
    for (int exponent = floor_log10(lo); exponent <= floor_log10(hi); ++exponent) {
        if (exponent % every != 0) continue;
        add(exponent, 1, true);
        if (every > 1) continue;
        for (int digit = 2; digit <= 9; ++digit) {
            add(exponent, digit, numbered_2_and_5 && (digit == 2 || digit == 5));
        }
    }
    return ticks;
}

namespace {

constexpr int kSides = 8;

Pixel normal(Pixel before, Pixel after) {
    const Pixel d{after.x - before.x, after.y - before.y};
    const double length = std::hypot(d.x, d.y);
    return length > 0 ? Pixel{d.y / length, -d.x / length} : Pixel{0.7, -0.7};
}

}  // namespace

Pixel side_direction(int side) {
    const double angle = side * 2 * std::numbers::pi / kSides;
    return {std::cos(angle), std::sin(angle)};
}

std::vector<int> label_sides(std::span<const Pixel> points) {
    const std::size_t n = points.size();
    std::vector<Pixel> normals;
    for (std::size_t i = 0; i < n; ++i) {
        normals.push_back(normal(points[i > 0 ? i - 1 : 0], points[std::min(i + 1, n - 1)]));
    }
    // Which way the curve bends, summed along it: labels stand on the other side.
    double bend = 0, upwards = 0;
    for (std::size_t i = 0; i < n; ++i) {
        upwards += normals[i].x - normals[i].y;
        if (i == 0 || i + 1 == n) continue;
        bend += (points[i - 1].x + points[i + 1].x - 2 * points[i].x) * normals[i].x +
                (points[i - 1].y + points[i + 1].y - 2 * points[i].y) * normals[i].y;
    }
    const double sign = std::abs(bend) > 1 ? (bend > 0 ? -1 : 1) : (upwards < 0 ? -1 : 1);
    std::vector<int> sides;
    for (const Pixel& direction : normals) {
        const double angle = std::atan2(sign * direction.y, sign * direction.x);
        const auto eighth = std::lround(angle / (2 * std::numbers::pi / kSides));
        sides.push_back(static_cast<int>((eighth + kSides) % kSides));
    }
    return sides;
}

PlotFrame::PlotFrame(const Plot& plot, const Extents& ends, const Box& box)
    : ends_(ends), log_x_(plot.x.logarithmic), log_y_(plot.y.logarithmic), box_(box) {}

double PlotFrame::place(double value, const Extent& extent, bool logarithmic, double at_lo,
                        double at_hi) {
    const auto scale = [&](double v) { return logarithmic ? std::log10(v) : v; };
    const double lo = scale(extent.lo), hi = scale(extent.hi);
    return at_lo + (scale(value) - lo) / (hi - lo) * (at_hi - at_lo);
}

bool PlotFrame::contains(double x_value, double y_value) const {
    const auto in = [](const Extent& e, double v) { return v >= e.lo && v <= e.hi; };
    return in(ends_.x, x_value) && in(ends_.y, y_value);
}

double tick_count(double length_px, double spacing_px) {
    return std::max(1.0, length_px / spacing_px);
}

PlotFrame fit_frame(const Plot& plot, Box box) {
    Extents ends = extents(plot);
    if (plot.equal_scale) {
        // Room for labels beyond the outermost points.
        widen(ends.x, plot.x, 1.1 * (ends.x.hi - ends.x.lo));
        widen(ends.y, plot.y, 1.1 * (ends.y.hi - ends.y.lo));
        const double width = ends.x.hi - ends.x.lo, height = ends.y.hi - ends.y.lo;
        const double unit_px = std::min(box.width() / width, box.height() / height);
        widen(ends.x, plot.x, box.width() / unit_px);
        widen(ends.y, plot.y, box.height() / unit_px);
        box.right = std::min(box.right, box.left + unit_px * (ends.x.hi - ends.x.lo));
        box.bottom = std::min(box.bottom, box.top + unit_px * (ends.y.hi - ends.y.lo));
    } else {
        if (!plot.x.logarithmic) {
            ends.x = rounded(ends.x, tick_count(box.width(), style::kTickSpacingX));
        }
        if (!plot.y.logarithmic) {
            ends.y = rounded(ends.y, tick_count(box.height(), style::kTickSpacingY));
        }
    }
    return {plot, ends, box};
}

}  // namespace nacre::report
