#pragma once

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace nacre::report::test {

/// What a strict reader finds in a page.
struct Scan {
    std::string error;                 ///< empty if every element closes in its turn
    std::vector<std::string> tags;     ///< names of the elements in their order
    std::vector<std::string> sources;  ///< values of src, srcset and of href outside <a>
    std::vector<std::string> links;    ///< values of href in <a>
    std::vector<std::string> ids;
    std::string text;  ///< what stands between the tags, scripts and styles left out

    int count(std::string_view tag) const {
        int n = 0;
        for (const std::string& t : tags) n += t == tag;
        return n;
    }
};

/// Reads a page more strictly than browsers do: attributes must be quoted and occur once, every
/// element must close but those that HTML leaves empty, no bare < or & may stand in the text.
inline Scan scan(std::string_view page) {
    static const std::set<std::string> kVoid = {"meta", "link", "img", "input"};
    Scan result;
    std::vector<std::string> open;
    std::size_t at = 0;
    const auto fail = [&](const std::string& why) {
        result.error = why + " before: " + std::string(page.substr(at, 80));
        return result;
    };
    const auto name_char = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '-';
    };
    const auto read_name = [&] {
        const std::size_t begin = at;
        while (at < page.size() && name_char(page[at])) ++at;
        return std::string(page.substr(begin, at - begin));
    };
    constexpr std::string_view kDoctype = "<!doctype html>";
    if (page.substr(0, kDoctype.size()) != kDoctype) return fail("no doctype");
    at = kDoctype.size();
    while (at < page.size()) {
        if (page[at] == '&') {
            const std::size_t end = page.find(';', at);
            static const std::set<std::string_view> kKnown = {"&amp", "&lt", "&gt", "&quot",
                                                              "&#39"};
            if (!kKnown.contains(page.substr(at, end - at))) return fail("unknown reference");
        }
        if (page[at] != '<') {
            result.text += page[at++];
            continue;
        }
        if (page.substr(at, 2) == "</") {
            at += 2;
            const std::string name = read_name();
            if (open.empty() || open.back() != name) return fail("</" + name + "> out of turn");
            open.pop_back();
            if (at >= page.size() || page[at] != '>') return fail("bad end tag");
            ++at;
            continue;
        }
        ++at;
        const std::string name = read_name();
        if (name.empty()) return fail("a bare <");
        result.tags.push_back(name);
        std::set<std::string> seen;
        while (at < page.size() && page[at] == ' ') {
            ++at;
            const std::string attribute = read_name();
            if (attribute.empty() || !seen.insert(attribute).second) return fail("bad attribute");
            if (page.substr(at, 2) != "=\"") return fail("an attribute without quotes");
            at += 2;
            const std::size_t end = page.find('"', at);
            if (end == std::string_view::npos) return fail("an open quote");
            const std::string value(page.substr(at, end - at));
            if (value.find_first_of("<>") != std::string::npos) return fail("< in an attribute");
            if (attribute.substr(0, 2) == "on") return fail("an event handler");
            if (attribute == "id") result.ids.push_back(value);
            if (attribute == "href" && name == "a") {
                result.links.push_back(value);
            } else if (attribute == "href" || attribute == "src" || attribute == "srcset") {
                result.sources.push_back(value);
            }
            at = end + 1;
        }
        if (page.substr(at, 2) == "/>") {
            at += 2;
            continue;
        }
        if (at >= page.size() || page[at] != '>') return fail("a bad tag");
        ++at;
        if (name == "script" || name == "style") {
            // Raw text up to the first end tag, whatever it means there.
            const std::size_t end = page.find("</" + name + ">", at);
            if (end == std::string_view::npos) return fail("an endless " + name);
            const std::string_view raw = page.substr(at, end - at);
            if (raw.find("<!--") != std::string_view::npos) return fail("<!-- in a " + name);
            at = end;
        }
        if (!kVoid.contains(name)) open.push_back(name);
    }
    if (!open.empty()) result.error = "<" + open.back() + "> does not close";
    return result;
}

/// The beginning of a PNG file.
inline std::string tiny_png() {
    using namespace std::string_literals;
    // The signature and IHDR of a picture of 3 x 2 pixels; what follows is not looked at.
    return "\x89PNG\r\n\x1a\n\0\0\0\x0DIHDR\0\0\0\x03\0\0\0\x02\x08\x02\0\0\0"s;
}

}  // namespace nacre::report::test
