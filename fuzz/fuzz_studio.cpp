#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "apps/studio/messages/frames.h"
#include "apps/studio/messages/http_rules.h"
#include "apps/studio/messages/messages.h"
#include "apps/studio/messages/own_files.h"
#include "apps/studio/messages/recipe_tree.h"
#include "nacre/core/error.h"
#include "nacre/io/recipe_file.h"
#include "nacre/io/table_reader.h"

// What a page sends is taken or refused with a MessageError; the recipe in it becomes a TOML text with
// the same tree, which is read or refused; a mesh or a light in it is read or refused. The target of a request is taken or refused.
static constexpr std::string_view kModels[] = {"microflake", "nacre"};

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    using namespace nacre::studio;
    const auto target = parse_target(text);
    if (target && target->path.size() > size) __builtin_trap();
    is_host(text, {"127.0.0.1", 80, true});

    Message message;
    try {
        message = parse_message(text, kModels);
    } catch (const MessageError& error) {
        error_frames(error.id(), "message", error);
        return 0;
    }
    try {
        if (const auto* shape = std::get_if<ShapeRequest>(&message.request)) {
            read_own_shape("own", shape->file, shape->bytes, shape->y_up);
        } else if (const auto* light = std::get_if<LightRequest>(&message.request)) {
            read_own_light("own", light->file, light->bytes);
        }
    } catch (const nacre::InputError& error) {
        error_frames(message.id, message.type, error);
    }
    const auto* paint = std::get_if<PaintRequest>(&message.request);
    if (!paint) return 0;
    try {
        const std::string toml = toml_of_tree(paint->recipe);
        if (toml.size() > nacre::io::kMaxTextBytes) return 0;
        if (toml_of_tree(tree_of_toml(toml, "recipe.toml"), toml) != toml) __builtin_trap();
        nacre::io::parse_recipe_file(toml, "recipe.toml", {});
    } catch (const nacre::InputError& error) {
        error_frames(message.id, message.type, error);
    }
    return 0;
}
