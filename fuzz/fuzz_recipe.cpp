#include <cstddef>
#include <cstdint>
#include <string_view>

#include "nacre/core/error.h"
#include "nacre/io/recipe_file.h"

// A recipe is read or refused with an InputError; one that is read survives being written and
// read again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    nacre::io::RecipeFile file;
    try {
        file = nacre::io::parse_recipe_file(text, "fuzz.toml", "/nonexistent");
    } catch (const nacre::InputError&) {
        return 0;
    }
    const nacre::io::RecipeFile again = nacre::io::parse_recipe_file(
        nacre::io::write_recipe(file.recipe, file.bounds, file.deviations), "again.toml", "");
    if (again.recipe != file.recipe || again.bounds != file.bounds ||
        again.deviations != file.deviations) {
        __builtin_trap();
    }
    return 0;
}
