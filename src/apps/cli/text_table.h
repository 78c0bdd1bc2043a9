#pragma once

#include <string>
#include <vector>

namespace nacre::cli {

/// A table for people: the first column to the left, the others to the right, two spaces between,
/// the header above. Cells of columns that are empty throughout are left out with their header.
std::string text_table(const std::vector<std::vector<std::string>>& rows);

/// A number with so many decimals, a zero without sign, others with `sign` always with theirs.
std::string rounded(double value, int decimals, bool sign = false);

}  // namespace nacre::cli
