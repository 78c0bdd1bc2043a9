#include "apps/report/report.h"

#include <fmt/format.h>

#include <algorithm>

#include "apps/report/markup.h"
#include "apps/report/parts.h"
#include "nacre/core/error.h"

namespace nacre::report {

namespace {

bool is_anchor(const std::string& text) {
    const auto letter = [](char c) { return c >= 'a' && c <= 'z'; };
    const auto allowed = [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '-'; };
    return !text.empty() && letter(text[0]) && std::all_of(text.begin(), text.end(), allowed);
}

}  // namespace

Report::Report(std::string title, std::string subtitle)
    : title_(std::move(title)), subtitle_(std::move(subtitle)) {}

void Report::heading(int level, const std::string& text, const std::string& anchor) {
    if (level < 1 || level > 3) {
        throw DomainError(fmt::format("heading '{}': level = {} is outside [1, 3]", text, level));
    }
    std::string name = anchor;
    if (anchor.empty()) {
        const std::string base = slug(text);
        name = base;
        for (int n = 2; anchors_.contains(name); ++n) name = fmt::format("{}-{}", base, n);
    } else if (!is_anchor(anchor)) {
        throw DomainError(
            fmt::format("heading '{}': the anchor '{}' is not of small letters, digits and hyphens",
                        text, anchor));
    } else if (anchors_.contains(anchor)) {
        throw DomainError(fmt::format("heading '{}': the anchor '{}' is taken", text, anchor));
    }
    anchors_.insert(name);
    body_ += fmt::format("<h{0} id=\"{1}\">{2}</h{0}>\n", level + 1, name, markup_to_html(text));
    headings_.push_back({level, text, name});
}

void Report::paragraph(const std::string& text) {
    body_ += "<p>" + markup_to_html(text) + "</p>\n";
}

void Report::note(const std::string& text) {
    body_ += "<p class=\"note\" role=\"note\">" + markup_to_html(text) + "</p>\n";
}

void Report::bullets(const std::vector<std::string>& texts) {
    if (texts.empty()) return;
    body_ += "<ul>\n";
    for (const std::string& text : texts) body_ += "<li>" + markup_to_html(text) + "</li>\n";
    body_ += "</ul>\n";
}

void Report::definitions(const std::vector<Definition>& definitions) {
    if (definitions.empty()) return;
    body_ += "<dl>\n";
    for (const Definition& d : definitions) {
        body_ += "<dt>" + markup_to_html(d.term) + "</dt><dd>" + markup_to_html(d.description) +
                 "</dd>\n";
    }
    body_ += "</dl>\n";
}

void Report::table(const Table& table) { body_ += table_html(table, ++tables_); }

void Report::pictures(const std::vector<Picture>& pictures, int columns,
                      const std::string& caption) {
    body_ += pictures_html(pictures, columns, caption);
}

void Report::plot(const Plot& plot) {
    body_ += plot_html(plot, page_size(plot), numbers_html(plot));
}

std::string Report::html() const { return page_html(title_, subtitle_, headings_, body_); }

}  // namespace nacre::report
