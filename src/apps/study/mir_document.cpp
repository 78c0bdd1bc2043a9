#include "apps/study/mir_document.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "apps/study/mir_printed.h"
#include "nacre/core/error.h"

namespace nacre::study {
namespace {

using nlohmann::json;

constexpr std::string_view kBegin = "<!-- begin: ", kClose = " -->";

/// A cell must not end the cell or the row.
std::string cell_text(const std::string& text) {
    std::string out;
    for (char c : text) {
        if (c == '|') out += '\\';
        out += c == '\n' ? ' ' : c;
    }
    return out;
}

std::string markdown_row(const json& cells) {
    std::string row = "|";
    for (const json& cell : cells) {
        const std::string text = cell_text(cell.get<std::string>());
        row += text.empty() ? " |" : " " + text + " |";
    }
    return row + "\n";
}

std::string markdown_table(const json& table) {
    std::string text = "\n" + markdown_row(table.at("columns")) + "|";
    for (const json& numeric : table.at("numeric")) {
        text += numeric.get<bool>() ? " ---: |" : " --- |";
    }
    text += "\n";
    for (const json& row : table.at("rows")) text += markdown_row(row);
    return text + "\n";
}

std::string setting_line(const json& results) {
    const int size = results.at("size"), samples = results.at("samples_per_pixel");
    const bool scaled_down = size < printed::kPictureSize || samples < printed::kSamples;
    return fmt::format(
        "\n{0} x {0} pixels, {1} samples each{2}; nacre {3}, seed {4}; {5}.{6}\n\n", size, samples,
        results.at("quick").get<bool>() ? " (a quick run: smaller tables, fewer curves)" : "",
        results.at("version").get<std::string>(), results.at("seed").get<std::uint64_t>(),
        results.at("hardware").get<std::string>(),
        scaled_down
            ? fmt::format(" **Scaled down** from {0} x {0} pixels at {1} samples: times, noise and "
                          "the ratios that follow are those of small pictures.",
                          printed::kPictureSize, printed::kSamples)
            : "");
}

}  // namespace

void require_markers(const std::string& markdown, const std::string& name) {
    if (markdown.find(kBegin) == std::string::npos) {
        throw InputError(fmt::format("{}: has no marker '{}NAME{}'", name, kBegin, kClose));
    }
}

std::string with_tables(const std::string& markdown, const std::string& name, const json& results) {
    require_markers(markdown, name);
    std::string out;
    std::size_t at = 0;
    try {
        while (true) {
            const std::size_t begin = markdown.find(kBegin, at);
            if (begin == std::string::npos) break;
            const std::size_t close = markdown.find(kClose, begin);
            if (close == std::string::npos) {
                throw InputError(fmt::format("{}: a marker '{}' has no end", name, kBegin));
            }
            const std::string table =
                markdown.substr(begin + kBegin.size(), close - begin - kBegin.size());
            const std::string end_marker = fmt::format("<!-- end: {} -->", table);
            const std::size_t end = markdown.find(end_marker, close);
            if (end == std::string::npos) {
                throw InputError(fmt::format("{}: '<!-- begin: {} -->' has no '{}' after it", name,
                                             table, end_marker));
            }
            out += markdown.substr(at, close + kClose.size() - at) + "\n";
            if (table == "setting") {
                out += setting_line(results);
            } else if (results.at("tables").contains(table)) {
                out += markdown_table(results.at("tables").at(table));
            } else {
                throw InputError(fmt::format("{}: the results have no table '{}'", name, table));
            }
            out += end_marker;
            at = end + end_marker.size();
        }
    } catch (const json::exception& e) {
        throw InputError(
            fmt::format("{}: the results are not those of a study: {}", name, e.what()));
    }
    return out + markdown.substr(at);
}

}  // namespace nacre::study
