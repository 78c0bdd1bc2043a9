#include "nacre/report/ticks.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace nacre::report {

namespace {

// From here on, and below the second, numbers are written with powers of ten.
constexpr double kLargestPlain = 1e6, kSmallestPlain = 1e-3;
// A double has fifteen digits for certain: beyond this, neighbouring multiples look alike.
constexpr double kLargestIndex = 1e14;

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
    if (size >= kLargestPlain || size < kSmallestPlain) {
        return scientific(value, std::clamp(floor_log10(size) - place, 0, 15));
    }
    return signed_text(fmt::format("{:.{}f}", value, std::clamp(-place, 0, 15)));
}

std::vector<Tick> linear_ticks(double lo, double hi, double count) {
    const double step = tick_step(lo, hi, count);
    // Ends that are multiples of the step but for rounding count.
    const double first = std::ceil(lo / step - 1e-9), last = std::floor(hi / step + 1e-9);
    std::vector<Tick> ticks;
    if (!(std::max(std::abs(first), std::abs(last)) < kLargestIndex)) return ticks;
    // One form for all numbers of an axis: with powers of ten if its largest needs them.
    const double largest = std::max(std::abs(first), std::abs(last)) * step;
    const bool plain = largest < kLargestPlain && largest >= kSmallestPlain;
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
    const int every = std::max(1, static_cast<int>(std::ceil(decades / std::max(1.0, count))));
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

}  // namespace nacre::report
