#include <nacre/nacre.h>
#include <nacre/render.h>

#include <cstdio>
#include <exception>

// A ball of the paint, as a picture.

int main(int argc, char** argv) {
    if (argc != 3) {
        std::fprintf(stderr, "usage: picture PAINT PICTURE.exr\n");
        return 1;
    }
    try {
        const nacre::Scene scene(nacre::find_scene("sphere"), {.slot = nacre::open(argv[1])});
        scene.render({.width = 64, .height = 64, .samples_per_pixel = 16}).write(argv[2]);
    } catch (const std::exception& error) {
        std::fprintf(stderr, "picture: %s\n", error.what());
        return 2;
    }
}
