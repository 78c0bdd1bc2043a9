#include <nacre/core/progress.h>
#include <nacre/nacre.h>
#include <nacre/render.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>

// A ball of the paint, as a picture: linear light in an .exr, tone-mapped in a .png. On a terminal a
// bar shows how far it is.

int main(int argc, char** argv) {
    if ((argc != 3 && argc != 5) || std::filesystem::path(argv[2]).extension() != ".exr") {
        std::fprintf(stderr, "usage: picture PAINT PICTURE.exr [SIZE SAMPLES_PER_PIXEL]\n");
        return 1;
    }
    try {
        const int size = argc == 5 ? std::atoi(argv[3]) : 64;
        const int samples = argc == 5 ? std::atoi(argv[4]) : 16;
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
