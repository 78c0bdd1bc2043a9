#include "nacre/spectra/observer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/core/text.h"

namespace nacre::spectra {
namespace {

// What CMake writes for "nan" in the files: the power where the CIE publishes none.
constexpr double kNotTabulated = 0;

// The tables are indexed by wavelength: there must be no gap.
template <class Table>
constexpr bool has_equal_steps(const Table& table) {
    for (std::size_t i = 1; i < table.size(); ++i) {
        if (table[i].wavelength_nm != table[i - 1].wavelength_nm + kCieStep_nm) return false;
    }
    return true;
}

constexpr ObserverRow kObservers[] = {
#include "cie_observers.inc"
};
constexpr IlluminantRow kIlluminants[] = {
#include "cie_illuminants.inc"
};
static_assert(std::size(kObservers) == kObserverRows);
static_assert(std::size(kIlluminants) == kIlluminantRows);
static_assert(has_equal_steps(std::to_array(kObservers)));
static_assert(has_equal_steps(std::to_array(kIlluminants)));

}  // namespace

constexpr std::array<ObserverRow, kObserverRows> kObserverTable = std::to_array(kObservers);
constexpr std::array<IlluminantRow, kIlluminantRows> kIlluminantTable = std::to_array(kIlluminants);

namespace {

// Where a wavelength lies in a table: between rows i and i + 1 at fraction t; outside if i < 0.
struct Place {
    int i;
    double t;
};

Place find(double wavelength_nm, double first_nm, int rows) {
    if (!std::isfinite(wavelength_nm)) {
        throw DomainError(fmt::format("wavelength in nm = {} is not finite", wavelength_nm));
    }
    const double position = (wavelength_nm - first_nm) / kCieStep_nm;
    if (!(position >= 0 && position <= rows - 1)) return {-1, 0};
    const int i = std::min(static_cast<int>(position), rows - 2);
    return {i, position - i};
}

/// What files write behind the field of an observer.
constexpr std::string_view kDegreeWords[] = {"",        "deg",  "deg.",  "degree",
                                             "degrees", "grad", "\u00b0"};

const std::vector<std::string> kIlluminantNames = {"A", "D50", "D65", "FL2", "FL11", "E"};

}  // namespace

Vec3d colour_matching(Observer observer, double wavelength_nm) {
    const auto [i, t] = find(wavelength_nm, kObserverTable[0].wavelength_nm, kObserverRows);
    if (i < 0) return {0, 0, 0};
    const int first = observer == Observer::cie1931_2deg ? 0 : 3;
    Vec3d xyz;
    for (int c = 0; c < 3; ++c) {
        xyz[c] =
            std::lerp(kObserverTable[i].xyz[first + c], kObserverTable[i + 1].xyz[first + c], t);
    }
    return xyz;
}

double illuminant_power(Illuminant illuminant, double wavelength_nm) {
    const auto [i, t] = find(wavelength_nm, kIlluminantTable[0].wavelength_nm, kIlluminantRows);
    if (illuminant == Illuminant::E) return 100;
    if (i < 0) return 0;
    const int column = static_cast<int>(illuminant);
    const double left = kIlluminantTable[i].power[column];
    const double right = kIlluminantTable[i + 1].power[column];
    // Between the last wavelength without data and the first with: outside the data.
    if (left == 0 && t < 1) return 0;
    return std::lerp(left, right, t);
}

Observer parse_observer(const std::string& text) {
    const std::string small = lowercase(trimmed(text));
    const std::size_t digits = std::min(small.find_first_not_of("0123456789"), small.size());
    const std::string_view field = std::string_view(small).substr(0, digits);
    const std::string unit = replaced(std::string_view(small).substr(digits), "_", " ");
    if (std::ranges::find(kDegreeWords, trimmed(unit)) != std::end(kDegreeWords)) {
        if (field == "2") return Observer::cie1931_2deg;
        if (field == "10") return Observer::cie1964_10deg;
    }
    throw InputError(fmt::format(
        "observer '{}' is unknown; use 2 (CIE 1931) or 10 (CIE 1964), the field in degrees", text));
}

Illuminant parse_illuminant(const std::string& text) {
    const auto found = std::find(kIlluminantNames.begin(), kIlluminantNames.end(), text);
    if (found == kIlluminantNames.end()) {
        throw InputError(fmt::format("illuminant '{}' is unknown{}; use one of {}", text,
                                     did_you_mean(text, kIlluminantNames),
                                     fmt::join(kIlluminantNames, ", ")));
    }
    return static_cast<Illuminant>(found - kIlluminantNames.begin());
}

std::string name(Illuminant illuminant) {
    return kIlluminantNames[static_cast<std::size_t>(illuminant)];
}

std::string name(Observer observer) { return observer == Observer::cie1931_2deg ? "2" : "10"; }

}  // namespace nacre::spectra
