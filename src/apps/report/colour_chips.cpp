#include "apps/report/colour_chips.h"

#include <fmt/format.h>

#include "apps/report/markup.h"

namespace nacre::report {

std::string chips_svg(const std::string& title, const std::vector<std::string>& lines,
                      const std::string& first, const std::string& second,
                      const std::vector<ChipGroup>& groups) {
    constexpr int kMargin = 16, kLine = 20, kRow = 30, kChip = 130, kLabel = 110, kWidth = 700;
    std::string body;
    int y = kMargin;
    const auto text = [&](int x, int at, const std::string& words, const char* style) {
        body +=
            fmt::format("<text x=\"{}\" y=\"{}\"{}>{}</text>\n", x, at, style, escape_html(words));
    };
    text(kMargin, y + 14, title, " font-size=\"16\" font-weight=\"bold\"");
    y += 26;
    for (const std::string& line : lines) {
        text(kMargin, y + 12, line, "");
        y += kLine;
    }
    const int left = kMargin + kLabel, right = left + kChip, notes = right + kChip + 12;
    for (const ChipGroup& group : groups) {
        y += 12;
        text(kMargin, y + 12, group.title, " font-weight=\"bold\"");
        y += kLine;
        text(left, y + 12, first, "");
        text(right, y + 12, second, "");
        y += kLine;
        for (const ChipPair& pair : group.pairs) {
            text(kMargin, y + 20, pair.label, "");
            for (const auto& [x, colour] :
                 {std::pair{left, &pair.first}, std::pair{right, &pair.second}}) {
                body += fmt::format(
                    "<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"{}\"/>\n", x, y,
                    kChip, kRow, escape_html(*colour));
            }
            text(notes, y + 20, pair.note, "");
            y += kRow;
        }
    }
    y += kMargin;
    return fmt::format(
        "{}\n<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{}\" height=\"{}\" "
        "viewBox=\"0 0 {} {}\" font-family=\"sans-serif\" font-size=\"12\">\n"
        "<rect width=\"{}\" height=\"{}\" fill=\"#ffffff\"/>\n{}</svg>\n",
        kChipsMark, kWidth, y, kWidth, y, kWidth, y, body);
}

}  // namespace nacre::report
