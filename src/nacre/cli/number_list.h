#pragma once

#include <string>
#include <vector>

#include "nacre/core/range.h"

namespace nacre::cli {

inline constexpr std::size_t kMostNumbers = 100'000;

/// The numbers of an option: one value, a comma list, or first:last:step (last is included if a
/// whole number of steps leads there), or a comma list of such.
///
/// @param option  for messages, as in "--wavelength"
/// @throws UsageError naming option, text and what is allowed
std::vector<double> parse_numbers(const std::string& option, const std::string& text,
                                  const Range& range);

/// One number.
double parse_number(const std::string& option, const std::string& text, const Range& range);

/// Parts between separators; at least one, possibly empty.
std::vector<std::string> split(const std::string& text, char separator);

}  // namespace nacre::cli
