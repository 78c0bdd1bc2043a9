#include "apps/report/page.h"

#include <algorithm>
#include <cctype>

#include "apps/report/markup.h"
#include "nacre/core/text.h"

namespace nacre::report {

namespace {

// The browser itself refuses whatever is not in the page: a report cannot reach the network.
constexpr std::string_view kSecurityPolicy =
    "default-src 'none'; img-src data:; style-src 'unsafe-inline'; base-uri 'none'; form-action "
    "'none'";

}  // namespace

std::string slug(const std::string& text) {
    constexpr std::size_t kLongest = 60;
    std::string name;
    for (const char c : lowercase(markup_to_plain(text))) {
        if (name.size() >= kLongest) break;
        if (std::isalnum(static_cast<unsigned char>(c))) {
            name += c;
        } else if (!name.empty() && name.back() != '-') {
            name += '-';
        }
    }
    while (!name.empty() && name.back() == '-') name.pop_back();
    if (name.empty() || !std::isalpha(static_cast<unsigned char>(name[0]))) {
        name = name.empty() ? "section" : "section-" + name;
    }
    return name;
}

std::string contents_html(const std::vector<Heading>& headings) {
    std::string items;
    int count = 0;
    for (const Heading& heading : headings) {
        if (heading.level > 2) continue;
        ++count;
        // The heading's text may hold links, and those must not stand inside one another.
        items += "<li class=\"level-" + std::to_string(heading.level) + "\"><a href=\"#" +
                 heading.anchor + "\">" + escape_html(markup_to_plain(heading.text)) +
                 "</a></li>\n";
    }
    if (count < 2) return {};
    return "<nav aria-label=\"Contents\">\n<p>Contents</p>\n<ul>\n" + items + "</ul>\n</nav>\n";
}

std::string page_html(const std::string& title, const std::string& subtitle,
                      const std::vector<Heading>& headings, const std::string& body,
                      std::string_view more_css) {
    std::string page = "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
    page += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
    page += "<meta http-equiv=\"Content-Security-Policy\" content=\"";
    page += kSecurityPolicy;
    page += "\">\n<link rel=\"icon\" href=\"data:,\">\n";  // else browsers ask the server for one
    page += "<title>" + escape_html(title) + "</title>\n<style>\n";
    page += page_css();
    page += more_css;
    page += "</style>\n</head>\n<body>\n<header>\n<h1>" + escape_html(title) + "</h1>\n";
    if (!subtitle.empty()) {
        page += "<p class=\"subtitle\">" + markup_to_html(subtitle) + "</p>\n";
    }
    page += "</header>\n" + contents_html(headings) + "<main>\n" + body + "</main>\n";
    return page + "</body>\n</html>\n";
}

}  // namespace nacre::report
