#pragma once

#include <string>

#include "nacre/report/plot.h"

// A plot as a picture that needs no script: for print, for mail, for a paper.

namespace nacre::report {

struct SvgSize {
    double width_px = 720;
    double height_px = 420;

    friend bool operator==(const SvgSize&, const SvgSize&) = default;
};

inline constexpr double kSmallestSvg = 120, kLargestSvg = 10'000;  // px a side

/// The plot as SVG 1.1: valid XML, drawn the way plots.js does, with its title and a legend above
/// it, text as text in the viewer's sans-serif font. It has no scripts, styles, links or ids, so
/// that it can stand in a page as often as wanted; the caption becomes its description.
/// @throws DomainError as check(plot), or if a side is outside [kSmallestSvg, kLargestSvg]
std::string plot_svg(const Plot& plot, const SvgSize& size = {});

}  // namespace nacre::report
