#pragma once

#include <string>
#include <string_view>
#include <vector>

// Files beside this one that become part of the page (CMakeLists.txt).

namespace nacre::report {

std::string_view page_css();
std::string_view plots_js();

struct Heading {
    int level = 1;       ///< 1 to 3
    std::string text;    ///< with markup
    std::string anchor;  ///< its name in the page
};

/// A name for links made of a text's letters and digits, as in "table-1-the-reference", cut off
/// after 60.
std::string slug(const std::string& text);

/// A list of links to the headings of levels 1 and 2; empty for fewer than two.
std::string contents_html(const std::vector<Heading>& headings);

/// The plotting scripts as elements, with their licences before them.
/// @throws InputError if a file is not in the data folder
std::string plotting_scripts();

/// The page around its body.
/// @param with_plots whether the plotting scripts follow the body; without them browsers are told
///                   to run no script at all
/// @param more_css   of a page with parts of its own; must hold no "</"
/// @throws InputError as plotting_scripts
std::string page_html(const std::string& title, const std::string& subtitle,
                      const std::vector<Heading>& headings, const std::string& body,
                      bool with_plots, std::string_view more_css = {});

}  // namespace nacre::report
