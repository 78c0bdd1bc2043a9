#include "apps/cli/text_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace nacre::cli {

namespace {

/// Characters of UTF-8: bytes that do not continue one.
std::size_t width(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](unsigned char byte) { return (byte & 0xc0) != 0x80; }));
}

}  // namespace

std::string text_table(const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> widths(rows.empty() ? 0 : rows[0].size());
    for (std::size_t c = 0; c < widths.size(); ++c) {
        bool empty = true;
        for (std::size_t r = 0; r < rows.size(); ++r) {
            widths[c] = std::max(widths[c], width(rows[r][c]));
            empty = empty && (r == 0 || rows[r][c].empty());
        }
        if (empty) widths[c] = 0;
    }
    std::string text;
    for (const std::vector<std::string>& row : rows) {
        std::string line;
        for (std::size_t c = 0; c < widths.size(); ++c) {
            if (widths[c] == 0) continue;
            const std::string space(widths[c] - std::min(widths[c], width(row[c])), ' ');
            line += (line.empty() ? "" : "  ") + (c == 0 ? row[c] + space : space + row[c]);
        }
        text += line.substr(0, line.find_last_not_of(' ') + 1) + "\n";
    }
    return text;
}

std::string rounded(double value, int decimals, bool sign) {
    std::string text =
        sign ? fmt::format("{:+.{}f}", value, decimals) : fmt::format("{:.{}f}", value, decimals);
    if (text.find_first_of("123456789") == std::string::npos &&
        (text[0] == '-' || text[0] == '+')) {
        text.erase(0, 1);
    }
    return text;
}

}  // namespace nacre::cli
