#include <nacre/core/progress.h>
#include <nacre/nacre.h>
#include <nacre/render.h>

#include <charconv>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <string>

// A ball of the paint, as a picture: linear light in an .exr, tone-mapped in a .png. On a terminal a
// bar shows how far it is.

static int whole_number(const std::string& text) {
    int value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
        throw std::invalid_argument("'" + text + "' is no whole number");
    return value;
}

int main(int argc, char** argv) {
    if ((argc != 3 && argc != 5) || std::filesystem::path(argv[2]).extension() != ".exr") {
        std::fprintf(stderr, "usage: picture PAINT PICTURE.exr [SIZE SAMPLES_PER_PIXEL]\n");
        return 1;
    }
    try {
        const int size = argc == 5 ? whole_number(argv[3]) : 64;
        const int samples = argc == 5 ? whole_number(argv[4]) : 16;
        const nacre::Scene scene(nacre::find_scene("sphere"), {.slot = nacre::open(argv[1])});
        nacre::ProgressBar bar("render");
        const nacre::Picture picture = scene.render(
            {.width = size, .height = size, .samples_per_pixel = samples, .noise = true},
            bar.callback());
        picture.write(argv[2]);
        picture.write(std::filesystem::path(argv[2]).replace_extension(".png"));
    } catch (const std::exception& error) {
        std::fprintf(stderr, "picture: %s\n", error.what());
        return 2;
    }
}
