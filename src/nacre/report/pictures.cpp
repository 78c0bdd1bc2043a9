#include <cstdint>
#include <optional>

#include "nacre/core/error.h"
#include "nacre/report/base64.h"
#include "nacre/report/escape.h"
#include "nacre/report/markup.h"
#include "nacre/report/parts.h"

namespace nacre::report {

namespace {

struct Size {
    std::uint32_t width, height;
};

// The size of a PNG picture, from its first chunk, IHDR.       [iso-15948-2004, section 11.2.2]
std::optional<Size> png_size(std::string_view bytes) {
    using namespace std::string_view_literals;
    constexpr std::string_view kBeginning = "\x89PNG\r\n\x1a\n\0\0\0\x0DIHDR"sv;
    if (bytes.size() < kBeginning.size() + 8 || bytes.substr(0, kBeginning.size()) != kBeginning) {
        return {};
    }
    const auto number = [&](std::size_t at) {
        std::uint32_t value = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            value = value << 8 | static_cast<std::uint8_t>(bytes[at + i]);
        }
        return value;
    };
    const Size size{number(kBeginning.size()), number(kBeginning.size() + 4)};
    if (size.width == 0 || size.height == 0) return {};
    return size;
}

}  // namespace

std::string pictures_html(const std::vector<Picture>& pictures, int columns,
                          const std::string& caption) {
    if (columns < 1 || columns > 8) {
        throw DomainError(fmt::format("pictures: columns = {} is outside [1, 8]", columns));
    }
    std::string html = fmt::format(
        "<figure class=\"pictures\">\n<div class=\"grid\" style=\"--columns:{}\">\n", columns);
    for (const Picture& picture : pictures) {
        const auto size = png_size(picture.png_bytes);
        if (!size) {
            throw DomainError(fmt::format("the picture '{}' is no PNG file", picture.caption));
        }
        // The hidden check box remembers whether the picture is enlarged: no script is needed.
        const std::string plain = escape_html(markup_to_plain(picture.caption));
        html += fmt::format(
            "<figure><label><input type=\"checkbox\" aria-label=\"Enlarge: {0}\"><img "
            "alt=\"{0}\" width=\"{1}\" height=\"{2}\" src=\"data:image/png;base64,{3}\"></label>",
            plain, size->width, size->height, base64(picture.png_bytes));
        if (!picture.caption.empty()) {
            html += "<figcaption>" + markup_to_html(picture.caption) + "</figcaption>";
        }
        html += "</figure>\n";
    }
    html += "</div>\n";
    if (!caption.empty()) html += "<figcaption>" + markup_to_html(caption) + "</figcaption>\n";
    return html + "</figure>\n";
}

}  // namespace nacre::report
