#pragma once

#include <string>
#include <vector>

// Colours side by side, as a picture.

namespace nacre::report {

/// Two colours that touch, and what is said of them.
struct ChipPair {
    std::string label;          ///< before them
    std::string first, second;  ///< colours of CSS
    std::string note;           ///< after them
};
struct ChipGroup {
    std::string title;
    std::vector<ChipPair> pairs;
};

/// What the file begins with, so that it can be told from those of other programs.
inline constexpr const char* kChipsMark = "<!-- nacre:chips -->";

/// An SVG of groups one below the other.
/// @param headings  of the two columns of colours
/// @param lines  of text below the title
std::string chips_svg(const std::string& title, const std::vector<std::string>& lines,
                      const std::string& first, const std::string& second,
                      const std::vector<ChipGroup>& groups);

}  // namespace nacre::report
