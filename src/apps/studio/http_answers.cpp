#include "apps/studio/http_answers.h"

#include <algorithm>

#include "apps/studio/messages/stage.h"
#include "apps/studio/page_files.h"
#include "apps/studio/schema.h"
#include "nacre/core/error.h"
#include "nacre/core/text.h"

namespace nacre::studio {

namespace {

constexpr const char* kJson = "application/json";
constexpr const char* kBinary = "application/octet-stream";

/// What follows a prefix of a path; none if it has another.
std::optional<std::string> name_in(const std::string& path, std::string_view prefix) {
    if (!path.starts_with(prefix)) return std::nullopt;
    return path.substr(prefix.size());
}

}  // namespace

HttpAnswer error_answer(unsigned status, const std::string& why) {
    return {status, kJson,
            Tree{{"error", why}}.dump(-1, ' ', false, Tree::error_handler_t::replace) + "\n"};
}

void HttpAnswers::prepare(const std::function<bool()>& ending) {
    if (!schema_.empty()) return;
    Tree tree = schema([&](double) { return !ending(); });
    tree["start"] = toml_ ? Tree(*toml_) : Tree(nullptr);
    tree["reading_model"] = reading_model_;
    schema_ = tree.dump();
}

HttpAnswer HttpAnswers::answer(const Target& target, const std::function<bool()>& ending) {
    if (target.path.starts_with("/api/")) {
        try {
            return api_answer(target, ending);
        } catch (const InputError& error) {
            return error_answer(404, error.what());
        } catch (const DomainError& error) {
            return error_answer(400, error.what());
        } catch (const std::exception& error) {
            return error_answer(500, error.what());
        }
    }
    const std::string path = target.path == "/" ? "/index.html" : target.path;
    const auto file = std::ranges::find(page_files(), path, &PageFile::path);
    if (file == page_files().end()) return error_answer(404, "there is no such file");
    return {200, std::string(content_type(path)), std::string(file->bytes)};
}

HttpAnswer HttpAnswers::api_answer(const Target& target, const std::function<bool()>& ending) {
    if (target.path == "/api/schema") {
        prepare(ending);
        return {200, kJson, schema_};
    }
    if (const auto shape = name_in(target.path, "/api/shape/")) {
        return {200, kBinary, shape_bytes({.shape = *shape})};
    }
    if (const auto light = name_in(target.path, "/api/light/")) {
        double width = kUsualLightWidth;
        if (const auto given = target.query.find("width"); given != target.query.end()) {
            const auto number = parse_number(given->second);
            if (!number) throw DomainError("width = " + excerpt(given->second) + ": is no number");
            width = *number;
        }
        require_in_range(width, kLightWidth.lo, kLightWidth.hi, "width in pixels");
        return {200, kBinary, light_bytes({.light = *light}, static_cast<int>(width))};
    }
    return error_answer(404,
                        "there are /api/schema, /api/shape/NAME, /api/light/NAME and the "
                        "WebSocket /api/session");
}

}  // namespace nacre::studio
