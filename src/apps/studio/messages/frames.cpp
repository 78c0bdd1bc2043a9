#include "apps/studio/messages/frames.h"

#include <regex>

namespace nacre::studio {

Frames error_frames(const Tree& id, const std::string& type, const std::exception& error) {
    const std::string message = error.what();
    Tree json = {{"type", "error"}, {"id", id}, {"about", type}, {"message", message}};
    // "recipe.toml:7:16: layer[0].thickness_um = -3: must be a number in (0, 1000000] um"
    static const std::regex place(R"(^[^:\n]{1,300}:(\d{1,7}):(\d{1,7}): ([\s\S]*)$)");
    static const std::regex value(
        R"(^([A-Za-z0-9_.\[\]"-]{1,300})( = [^\n]{0,200}?)?: ([\s\S]*)$)");
    static const std::regex range(
        R"([\[(]-?[0-9.e+-]+, (?:-?[0-9.e+-]+|inf)[\])](?: [A-Za-z0-9/^]+)?)");
    std::string rest = message.substr(0, 2000);
    std::smatch found;
    if (std::regex_match(rest, found, place)) {
        json["line"] = std::stoi(found[1]);
        json["column"] = std::stoi(found[2]);
        rest = std::string(found[3]);
    }
    if (std::regex_match(rest, found, value)) {
        json["key"] = found[1].str();
        rest = std::string(found[3]);
    }
    if (std::regex_search(rest, found, range)) json["range"] = found[0].str();
    return {{dumped(json), {}}};
}

std::string dumped(const Tree& tree) {
    return tree.dump(-1, ' ', false, Tree::error_handler_t::replace);
}

}  // namespace nacre::studio
