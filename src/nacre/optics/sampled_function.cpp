#include "nacre/optics/sampled_function.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nacre/core/error.h"

namespace nacre::optics {

double SampledFunction::at(double wavelength_nm) const {
    const auto above =
        std::upper_bound(wavelengths_nm.begin(), wavelengths_nm.end() - 1, wavelength_nm);
    const auto i =
        std::max<std::size_t>(1, static_cast<std::size_t>(above - wavelengths_nm.begin()));
    const double t =
        (wavelength_nm - wavelengths_nm[i - 1]) / (wavelengths_nm[i] - wavelengths_nm[i - 1]);
    return values[i - 1] * (1 - t) + values[i] * t;
}

SampledFunction sample_smooth(const std::function<double(double)>& f, double first_nm,
                              double last_nm, double error, std::size_t most) {
    // The error of a smooth function is largest in the middle of an interval; asking for a quarter
    // of it there leaves room for intervals that are not yet quite parabolic.
    const double allowed = error / 4;
    constexpr int start = 64;  // intervals, equal on a logarithmic scale
    struct Interval {
        double left_nm, right_nm, f_left, f_right;
    };
    std::vector<Interval> open;  // a stack, leftmost on top
    double right_nm = last_nm, f_right = f(last_nm);
    for (int i = start - 1; i >= 0; --i) {
        const double left_nm =
            i == 0 ? first_nm
                   : first_nm * std::pow(last_nm / first_nm, static_cast<double>(i) / start);
        if (!(left_nm < right_nm)) continue;  // a range of a few roundings
        const double f_left = f(left_nm);
        open.push_back({left_nm, right_nm, f_left, f_right});
        right_nm = left_nm;
        f_right = f_left;
    }
    SampledFunction result{{first_nm}, {f_right}};
    while (!open.empty()) {
        const Interval interval = open.back();
        open.pop_back();
        const double middle_nm = (interval.left_nm + interval.right_nm) / 2;
        const double f_middle = f(middle_nm);
        const bool divisible = middle_nm > interval.left_nm && middle_nm < interval.right_nm;
        if (divisible && std::abs(f_middle - (interval.f_left + interval.f_right) / 2) > allowed) {
            if (open.size() + result.values.size() > most) {
                throw DomainError(fmt::format(
                    "the function changes so fast near {} nm that {} samples do not follow it; is "
                    "there a pole in the range?",
                    middle_nm, most));
            }
            open.push_back({middle_nm, interval.right_nm, f_middle, interval.f_right});
            open.push_back({interval.left_nm, middle_nm, interval.f_left, f_middle});
        } else {
            result.wavelengths_nm.push_back(interval.right_nm);
            result.values.push_back(interval.f_right);
        }
    }
    return result;
}

}  // namespace nacre::optics
