#pragma once

#include <string>

#include "apps/report/plot_svg.h"
#include "apps/report/report.h"

// The HTML of a report's larger parts. Names of elements inside (the notes of a table) contain an
// underscore, which those of headings cannot.

namespace nacre::report {

/// @param number makes names of elements unique in the page
/// @throws DomainError as Report::table
std::string table_html(const Table& table, int number);

/// @throws DomainError as Report::pictures
std::string pictures_html(const std::vector<Picture>& pictures, int columns,
                          const std::string& caption);

/// The plot's legend, its place, its numbers as a table that unfolds, and its data for plots.js.
/// @throws DomainError as check(plot)
std::string plot_html(const Plot& plot, int number);

/// The plot drawn, in a figure with its caption.
/// @throws DomainError as plot_svg()
std::string static_plot_html(const Plot& plot, const SvgSize& size);

}  // namespace nacre::report
