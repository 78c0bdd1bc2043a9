#include "nacre/study/flakes_close_up.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "nacre/core/atomic_file.h"
#include "nacre/core/error.h"
#include "nacre/core/sha256.h"
#include "nacre/io/image.h"
#include "nacre/io/version.h"
#include "nacre/render/scene.h"

namespace nacre::study {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr double kRadians = std::numbers::pi / 180;

Vec3f towards(double angle_deg, double distance_mm) {
    return {static_cast<float>(distance_mm * std::sin(angle_deg * kRadians)), 0,
            static_cast<float>(distance_mm * std::cos(angle_deg * kRadians))};
}

io::Image image_of(const Pixels& picture, double scale) {
    io::Image image{picture.width, picture.height, {{"R", {}}, {"G", {}}, {"B", {}}}, {}};
    for (std::size_t i = 0; i < picture.rgb.size(); ++i)
        image.channels[i % 3].pixels.push_back(static_cast<float>(scale * picture.rgb[i]));
    return image;
}

std::string fingerprint(const CloseUpJob& job) {
    const json description = {
        {"version", io::version()}, {"surface", job.surface}, {"pixel_mm", job.pixel_mm},
        {"pixels", job.pixels},     {"samples", job.samples}, {"seed", job.seed},
        {"eye_deg", kEyeDeg},       {"lamp_deg", kLampDeg},   {"lamp_size_deg", kLampSizeDeg}};
    return sha256_hex(description.dump());
}

}  // namespace

double panel_side_mm(double pixel_mm, int pixels) {
    return 1.2 * pixel_mm * pixels / std::cos(kEyeDeg * kRadians);
}

render::SceneDescription close_up_scene(double pixel_mm, int pixels) {
    const double view_mm = pixel_mm * pixels;
    // So far away that directions over the view differ by less than a fifth of a degree.
    const double distance_mm = std::max(100.0, 300 * view_mm);
    render::SceneDescription scene;
    scene.name = "close-up";
    scene.camera.position_mm = towards(kEyeDeg, distance_mm);
    scene.camera.up = {0, 1, 0};
    scene.camera.vertical_fov_deg = 2 * std::atan(0.5 * view_mm / distance_mm) / kRadians;
    scene.materials["paint"] = render::PaintMaterial{};
    const double side = panel_side_mm(pixel_mm, pixels);
    scene.shapes.push_back({render::FlatPanel{side, side}, "paint", {}});
    render::RectangleLight lamp;
    lamp.center_mm = towards(-kLampDeg, distance_mm);
    lamp.width_mm = lamp.height_mm = 2 * distance_mm * std::tan(0.5 * kLampSizeDeg * kRadians);
    lamp.radiance.scale = 100;
    scene.lights.push_back(lamp);
    return scene;
}

CloseUps::CloseUps(fs::path folder, Stage stage)
    : folder_(std::move(folder)), stage_(std::move(stage)) {
    make_folder(folder_ / "pictures");
}

Pixels CloseUps::take(const CloseUpJob& job, const MakeSurface& surface) const {
    const fs::path exr = folder_ / "pictures" / (job.key + ".exr");
    const std::string print = fingerprint(job);
    if (fs::is_regular_file(exr)) {
        const io::Image image = io::read_image(exr);
        const auto found = image.metadata.find("nacre:fingerprint");
        if (found != image.metadata.end() && found->second == print)
            return {image.width, image.height, io::interleaved_rgb(image, exr.string())};
    }
    Pixels pixels{job.pixels, job.pixels, {}};
    stage_(job.title, [&](const Progress& progress) {
        const render::Scene scene(close_up_scene(job.pixel_mm, job.pixels), {{"paint", surface()}});
        render::RenderOptions options;
        options.width = options.height = job.pixels;
        options.samples_per_pixel = job.samples;
        options.seed = job.seed;
        render::RenderResult result = render::render(scene, options, progress);
        if (!result.complete) throw Interrupted("stopped");
        pixels.rgb = std::move(result.rgb);
        io::Image image = image_of(pixels, 1);
        image.metadata["nacre:fingerprint"] = print;
        io::write_exr(exr, image);
    });
    return pixels;
}

std::string CloseUps::png(const Pixels& picture, double mean, const std::string& key) const {
    const fs::path file = folder_ / "pictures" / (key + ".png");
    io::write_png(file, image_of(picture, 0.3 / mean));
    return read_file(file);
}

}  // namespace nacre::study
