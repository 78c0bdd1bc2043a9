#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "nacre/measure/difference.h"

// Whether a sample may pass for its standard: a limit on a colour difference at every angle.

namespace nacre::measure {

/// A colour difference formula.
struct DifferenceFormula {
    enum class Kind {
        cielab,     ///< Delta E*ab, the distance in L*a*b*                     [cie-15-2018]
        ciede2000,  ///< spectra::delta_e_2000()
        cmc         ///< CMC(l:c), spectra::delta_e_cmc()
    } kind = Kind::ciede2000;
    double l = 2, c = 1;  ///< of CMC, above 0

    double operator()(const Vec3d& lab_standard, const Vec3d& lab_sample) const;
    /// As parse_formula() reads it: "cie2000", "cmc2:1".
    std::string name() const;

    friend bool operator==(const DifferenceFormula&, const DifferenceFormula&) = default;
};

/// "cielab", "cie2000", "cmc" (2:1) or "cmcL:C" as in "cmc1:1".
/// @throws DomainError naming the text and what is allowed
DifferenceFormula parse_formula(const std::string& text);

struct Tolerance {
    DifferenceFormula formula;
    std::optional<double> limit = {};           ///< at angles that `limits` does not name; or none
    std::map<std::string, double> limits = {};  ///< by the geometry's name

    /// Whether anything can fail.
    bool has_limits() const { return limit || !limits.empty(); }
};

inline constexpr Range kToleranceLimit{0, 1000};

struct AngleVerdict {
    double delta_e = 0;  ///< by the tolerance's formula
    std::optional<double> limit = {};
    bool passes() const { return !limit || delta_e <= *limit; }
};

struct Verdict {
    Tolerance tolerance;
    std::vector<AngleVerdict> angles;  ///< as Difference::angles
    bool passes() const;
};

/// @throws DomainError if a limit is out of range or names no geometry of the comparison
Verdict judge(const Difference& difference, const Tolerance& tolerance);

}  // namespace nacre::measure
