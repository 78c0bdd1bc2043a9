#include <cmath>

#include "nacre/spectra/cie_tables.h"
#include "nacre/spectra/xyz.h"

namespace nacre::spectra {
namespace {

constexpr int kRows = static_cast<int>((kRenderLast_nm - kRenderFirst_nm) / kCieStep_nm) + 1;

// The colour-matching functions from 400 to 700 nm, multiplied by stratum width / Int y.
// The integral of a function that is linear between samples is the trapezoid sum.
std::array<Vec3, kRows> make_table() {
    std::array<Vec3, kRows> table;
    double integral = 0;
    for (int i = 0; i < kRows; ++i) {
        table[i] = colour_matching(Observer::cie1931_2deg, kRenderFirst_nm + i * kCieStep_nm);
        integral += (i == 0 || i == kRows - 1 ? 0.5 : 1.0) * kCieStep_nm * table[i][1];
    }
    const double width_nm = (kRenderLast_nm - kRenderFirst_nm) / 8;
    for (Vec3& row : table) {
        for (double& c : row) c *= width_nm / integral;
    }
    return table;
}

}  // namespace

std::array<std::array<float, 3>, 8> xyz_weights(const std::array<double, 8>& wavelengths_nm) {
    static const std::array<Vec3, kRows> table = make_table();
    std::array<std::array<float, 3>, 8> weights{};
    for (int k = 0; k < 8; ++k) {
        const double position = (wavelengths_nm[k] - kRenderFirst_nm) / kCieStep_nm;
        if (!(position >= 0 && position <= kRows - 1)) continue;
        const int i = position < kRows - 1 ? static_cast<int>(position) : kRows - 2;
        const double t = position - i;
        for (int c = 0; c < 3; ++c) {
            weights[k][c] = static_cast<float>(table[i][c] + t * (table[i + 1][c] - table[i][c]));
        }
    }
    return weights;
}

}  // namespace nacre::spectra
