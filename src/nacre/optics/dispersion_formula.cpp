#include "nacre/optics/dispersion_formula.h"

#include <cmath>
#include <limits>

#include "nacre/core/math.h"

namespace nacre::optics {

namespace {

/// C1, C2, ... counted from 1 as in the literature; 0 beyond the end.
class Coefficients {
 public:
    explicit Coefficients(std::span<const double> values) : values_(values) {}
    double operator()(std::size_t i) const { return i <= values_.size() ? values_[i - 1] : 0.0; }
    std::size_t size() const { return values_.size(); }

 private:
    std::span<const double> values_;
};

/// Sum of term(C_i, C_i+1) over the pairs from C_first on; a pair whose first number is 0 or
/// missing adds nothing, even where its second one would make a pole.
template <class Term>
double sum_of_pairs(const Coefficients& c, std::size_t first, Term term) {
    double sum = 0;
    for (std::size_t i = first; i <= c.size(); i += 2) {
        if (c(i) != 0) sum += term(c(i), c(i + 1));
    }
    return sum;
}

}  // namespace

double dispersion_formula(int number, std::span<const double> coefficients, double wavelength_um) {
    const Coefficients c(coefficients);
    const double w = wavelength_um, w2 = square(w);
    switch (number) {
        case 1:
            return std::sqrt(1 + c(1) + sum_of_pairs(c, 2, [&](double a, double b) {
                                 return a * w2 / (w2 - square(b));
                             }));
        case 2:
            return std::sqrt(1 + c(1) + sum_of_pairs(c, 2, [&](double a, double b) {
                                 return a * w2 / (w2 - b);
                             }));
        case 3:
            return std::sqrt(
                c(1) + sum_of_pairs(c, 2, [&](double a, double b) { return a * std::pow(w, b); }));
        case 4: {
            double sum = c(1);
            for (std::size_t i : {2, 6}) {
                if (c(i) != 0) {
                    sum += c(i) * std::pow(w, c(i + 1)) / (w2 - std::pow(c(i + 2), c(i + 3)));
                }
            }
            sum += sum_of_pairs(c, 10, [&](double a, double b) { return a * std::pow(w, b); });
            return std::sqrt(sum);
        }
        case 5:
            return c(1) +
                   sum_of_pairs(c, 2, [&](double a, double b) { return a * std::pow(w, b); });
        case 6:
            return 1 + c(1) +
                   sum_of_pairs(c, 2, [&](double a, double b) { return a / (b - 1 / w2); });
        case 7: {
            const double l = 1 / (w2 - 0.028);  // Herzberger's fixed resonance, um^2
            return c(1) + c(2) * l + c(3) * l * l + w2 * (c(4) + w2 * (c(5) + w2 * c(6)));
        }
        case 8: {
            // (n^2 - 1)/(n^2 + 2) = y, the Lorentz-Lorenz form
            const double y = c(1) + (c(2) != 0 ? c(2) * w2 / (w2 - c(3)) : 0) + c(4) * w2;
            return std::sqrt((1 + 2 * y) / (1 - y));
        }
        case 9: {
            double sum = c(1);
            if (c(2) != 0) sum += c(2) / (w2 - c(3));
            if (c(4) != 0) sum += c(4) * (w - c(5)) / (square(w - c(5)) + c(6));
            return std::sqrt(sum);
        }
        default:
            return std::numeric_limits<double>::quiet_NaN();
    }
}

}  // namespace nacre::optics
