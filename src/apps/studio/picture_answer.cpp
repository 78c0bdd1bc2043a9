#include <algorithm>
#include <cmath>

#include "apps/studio/answers.h"
#include "nacre/models/models.h"
#include "nacre/render.h"

// The path tracer's picture, which gets better while it is looked at.

namespace nacre::studio {

namespace {

/// Each picture that is sent has so many times as many samples as the one before, but for the last.
constexpr int kGrowth = 4;

std::string bytes_of(const std::vector<float>& rgb, bool linear) {
    std::string bytes(rgb.size(), '\0');
    std::ranges::transform(rgb, bytes.begin(), [](float light) {
        return static_cast<char>(io::display_byte(light, 1));
    });
    if (linear) {
        bytes.resize((bytes.size() + 3) / 4 * 4);
        bytes.append(reinterpret_cast<const char*>(rgb.data()), rgb.size() * sizeof(float));
    }
    return bytes;
}

void adapt(std::vector<float>& rgb, const Adaptation& adapted) {
    if (adapted.is_none()) return;
    for (std::size_t i = 0; i < rgb.size(); i += 3) {
        const Vec3d seen = adapted({rgb[i], rgb[i + 1], rgb[i + 2]});
        for (int c = 0; c < 3; ++c) rgb[i + c] = static_cast<float>(seen[c]);
    }
}

Frame picture_frame(const RenderRequest& request, const Context& context,
                    const render::RenderResult& picture) {
    const std::vector<int> shape = {request.height, request.width, 3};
    Tree binary = Tree::array();
    binary.push_back({{"name", "rgb"}, {"dtype", "u8"}, {"shape", shape}});
    if (request.linear) {
        binary.push_back({{"name", "linear"}, {"dtype", "f32"}, {"shape", shape}});
    }
    Tree json = {{"type", "picture"},          {"id", context.id},
                 {"samples", picture.samples}, {"of", request.samples},
                 {"width", request.width},     {"height", request.height},
                 {"seconds", picture.seconds}, {"binary", std::move(binary)}};
    json["noise"] = picture.noise ? Tree(*picture.noise) : Tree(nullptr);
    return {dumped(json), bytes_of(picture.rgb, request.linear)};
}

}  // namespace

Frames answer(const RenderRequest& request, const Context& context) {
    const NamedPaint named = paint_of(request.recipe, context);
    Stage stage = request.stage;
    context.memory.lend_own_files(stage);
    const Model model = request.model.empty() ? models::default_picture_model()
                                              : models::named_model(request.model);
    const Scene scene(scene_of(stage), {.slot = named.paint, .model = model}, context.progress);
    const RenderSettings settings{.width = request.width,
                                  .height = request.height,
                                  .samples_per_pixel = request.samples,
                                  .noise = true};
    // Each shard has one sample a pixel; the sum of all is the picture of `nacre render`, bit for
    // bit.
    render::RenderSums sums(settings);
    int next = render::flake_sampling_stride(request.samples);
    for (int sample = 1; sample <= request.samples; ++sample) {
        sums.add(scene.render_shard(settings, {sample, request.samples}, context.progress).sums);
        if (sample != next && sample != request.samples) continue;
        next = sample * kGrowth;
        render::RenderResult picture = render::develop(sums, settings);
        // Which samples came first is the renderer's choice; all of them have the wavelengths of all.
        adapt(picture.rgb, Adaptation(stage, sample == request.samples ? sample : 0));
        Frame frame = picture_frame(request, context, picture);
        if (sample == request.samples) return {std::move(frame)};
        context.send("picture", {std::move(frame)});
    }
    throw Error("a picture without samples");
}

Frames answer(const ShapeRequest& request, const Context& context) {
    const auto own = read_own_shape(context.memory.next_own_name("shape"), request.file,
                                    request.bytes, request.y_up);
    context.memory.set_own(own);
    const std::string bytes = shape_bytes({.shape = own->name, .own_shape = own});
    const auto& mesh = std::get<render::MeshFile>(own->shape.geometry);
    Tree binary = Tree::array();
    binary.push_back({{"name", "mesh"}, {"dtype", "u8"}, {"shape", {bytes.size()}}});
    return {{dumped({{"type", "shape"},
                     {"id", context.id},
                     {"shape", shape_json(*own)},
                     {"triangles", mesh.read->triangles.size()},
                     {"extent_mm", own->extent_mm},
                     {"shown_mm", own->extent_mm * own->shape.transform.scale},
                     {"binary", std::move(binary)}}),
             bytes}};
}

Frames answer(const LightRequest& request, const Context& context) {
    const auto own =
        read_own_light(context.memory.next_own_name("light"), request.file, request.bytes);
    context.memory.set_own(own);
    const std::string bytes = light_bytes({.light = own->name, .own_light = own}, kUsualLightWidth);
    Tree binary = Tree::array();
    binary.push_back({{"name", "light"}, {"dtype", "u8"}, {"shape", {bytes.size()}}});
    return {{dumped({{"type", "light"},
                     {"id", context.id},
                     {"light", {{"name", own->name}, {"title", own->title}, {"illuminant", "D65"}}},
                     {"width", own->picture.width},
                     {"height", own->picture.height},
                     {"note", own->note},
                     {"binary", std::move(binary)}}),
             bytes}};
}

}  // namespace nacre::studio
