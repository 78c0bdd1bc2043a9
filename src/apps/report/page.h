#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace nacre::report {

/// The file page.css beside this one (CMakeLists.txt).
std::string_view page_css();

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

/// The page around its body. Browsers are told to run no script and to fetch nothing.
/// @param more_css  of a page with parts of its own; must hold no "</"
std::string page_html(const std::string& title, const std::string& subtitle,
                      const std::vector<Heading>& headings, const std::string& body,
                      std::string_view more_css = {});

}  // namespace nacre::report
