#pragma once

#include <vector>

#include "nacre/solver/order_interpolation.h"

// Spectra of a paint's azimuthal orders are often few: of metals some wavelengths tell all others. A
// matrix of orders by wavelength, A, is then nearly A_S C, where A_S are some of its own columns; both
// are found by pivoted elimination [cheng-2005]. C holds for higher orders too, of which the columns of
// S are all that need be solved.

namespace nacre::solver {

/// Whether the rows' spectra may be few enough that `count` wavelengths tell them to about 1e-8: false
/// where they are far from it, as those of interference colours are, which takes little time.
/// @param rows  [row][block of wavelengths]
bool may_be_represented(const LaneBuffer& rows, int wavelengths, int count);

class RepresentativeWavelengths {
 public:
    /// @param rows         values [row][block of wavelengths], each row over what its errors are held to
    /// @param wavelengths  of them
    /// @param count        of representatives, up to as many
    RepresentativeWavelengths(const LaneBuffer& rows, int wavelengths, int count);

    /// Which they are, rising.
    const std::vector<int>& wavelengths() const { return wavelengths_; }

    /// A row at all wavelengths from that at the representatives, as what is solved for these alone has
    /// it. Lanes beyond the last wavelength repeat it.
    void at_all(const DoubleLanes* few, DoubleLanes* all) const;
    /// The values at the representatives of rows at all wavelengths, and all as interpolated from them.
    OrderValues chosen(const OrderValues& all) const;
    OrderValues again(const OrderValues& all) const;

 private:
    std::size_t blocks_;
    std::vector<int> wavelengths_;
    LaneBuffer weights_;  // [representative][block]
};

}  // namespace nacre::solver
