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

/// How large a plot is drawn where it has the width of the text to itself.
/// @throws DomainError as check(plot)
SvgSize page_size(const Plot& plot);

/// The plot's title, legend, drawing and caption. The drawing follows the width of the page; where
/// its letters would become too small to be read it scrolls instead (page.css).
/// @param size   of the drawing alone
/// @param after  HTML at the end of the figure
/// @throws DomainError as plot_svg()
std::string plot_html(const Plot& plot, const SvgSize& size, const std::string& after = {});

/// The numbers of a plot as a table that unfolds.
/// @throws DomainError as check(plot)
std::string numbers_html(const Plot& plot);

}  // namespace nacre::report
