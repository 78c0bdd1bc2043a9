#include "nacre/panel/painted_picture.h"

#include <variant>

#include "nacre/core/error.h"
#include "nacre/io/render_image.h"
#include "nacre/render/builtin_scenes.h"
#include "nacre/render/render.h"

namespace nacre::panel {

std::string painted_picture(std::shared_ptr<const bsdf::Bsdf> paint,
                            const PictureSettings& settings, const Progress& progress) {
    const render::SceneDescription description = render::builtin_scene(settings.scene);
    render::PaintTable paints;
    for (const auto& [name, material] : description.materials) {
        if (std::holds_alternative<render::PaintMaterial>(material)) paints[name] = paint;
    }
    const render::Scene scene(description, paints);
    const render::RenderResult result =
        render::render(scene,
                       {.width = settings.width,
                        .height = settings.height,
                        .samples_per_pixel = settings.samples_per_pixel,
                        .seed = settings.seed},
                       progress);
    if (!result.complete) throw Error("stopped");
    io::Image image = io::image_of(result, {});
    image.metadata.clear();  // such as the time it took: a report made twice is the same
    return io::encode_png(image, "a picture of " + settings.scene);
}

}  // namespace nacre::panel
