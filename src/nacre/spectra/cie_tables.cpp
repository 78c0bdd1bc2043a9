#include "nacre/spectra/cie_tables.h"

namespace nacre::spectra {
namespace {

// Stands for "nan" in the files: a lamp's power where the CIE publishes none.
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

}  // namespace nacre::spectra
