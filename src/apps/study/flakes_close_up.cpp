#include "apps/study/flakes_close_up.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "apps/study/folder.h"
#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/core/math.h"
#include "nacre/core/sha256.h"
#include "nacre/core/version.h"
#include "nacre/io/image.h"
#include "nacre/measure/panel_picture.h"
#include "nacre/render/scene.h"
#include "nacre/spectra/lab.h"
#include "nacre/spectra/rgb.h"

namespace nacre::study {
namespace {

// Steps of the histogram: three in each factor of two, over a factor of 2^12.
constexpr int kStepsPerOctave = 3, kOctavesBelow = 7, kOctavesAbove = 5;

}  // namespace

std::vector<double> luminance(const Pixels& picture) {
    std::vector<double> y(picture.rgb.size() / 3);
    for (std::size_t p = 0; p < y.size(); ++p) {
        const float* c = &picture.rgb[3 * p];
        y[p] = spectra::linear_rec709_to_xyz({c[0], c[1], c[2]})[1];
    }
    return y;
}

namespace {

measure::LuminancePicture luminance_picture(const Pixels& picture) {
    return {picture.width, picture.height, luminance(picture)};
}

}  // namespace

Estimate mean_luminance(const Pixels& a, const Pixels& b) {
    return measure::mean_luminance(luminance_picture(a), luminance_picture(b));
}

Estimate contrast(const Pixels& a, const Pixels& b) {
    return measure::pixel_contrast(luminance_picture(a), luminance_picture(b));
}

Histogram histogram(const Pixels& picture) {
    constexpr int kSteps = kStepsPerOctave * (kOctavesBelow + kOctavesAbove);
    const auto y = luminance(picture);
    double mean = 0;
    for (double v : y) mean += v / static_cast<double>(y.size());
    Histogram h;
    h.fraction.resize(kSteps);
    for (int i = 0; i < kSteps; ++i)
        h.centre.push_back(std::exp2((i + 0.5) / kStepsPerOctave - kOctavesBelow));
    for (double v : y) {
        const double octaves = std::log2(std::max(v, 1e-30 * mean) / mean);
        const double step = std::floor((octaves + kOctavesBelow) * kStepsPerOctave);
        h.fraction[static_cast<int>(std::clamp(step, 0.0, kSteps - 1.0))] +=
            1 / static_cast<double>(y.size());
    }
    return h;
}

ColourSpread colour_spread(const Pixels& picture, double mean_luminance) {
    constexpr double kShown = 0.3;
    const double scale = kShown / mean_luminance;
    ColourSpread spread;
    const std::size_t count = picture.rgb.size() / 3;
    const double n = static_cast<double>(count);
    double rgb[3] = {}, a = 0, b = 0, aa = 0, bb = 0;
    for (std::size_t p = 0; p < count; ++p) {
        const float* c = &picture.rgb[3 * p];
        for (int i = 0; i < 3; ++i) rgb[i] += c[i] / n;
        const Vec3d colour =
            spectra::linear_rec709_to_lab({scale * c[0], scale * c[1], scale * c[2]});
        spread.ab.push_back({colour[1], colour[2]});
        a += colour[1] / n;
        b += colour[2] / n;
        aa += colour[1] * colour[1] / n;
        bb += colour[2] * colour[2] / n;
    }
    spread.mean_lab =
        spectra::linear_rec709_to_lab({scale * rgb[0], scale * rgb[1], scale * rgb[2]});
    spread.a_deviation = std::sqrt(std::max(0.0, aa - a * a));
    spread.b_deviation = std::sqrt(std::max(0.0, bb - b * b));
    return spread;
}

namespace {

namespace fs = std::filesystem;
using nlohmann::json;

Vec3f towards(double angle_deg, double distance_mm) {
    return {static_cast<float>(distance_mm * std::sin(angle_deg * kDegree)), 0,
            static_cast<float>(distance_mm * std::cos(angle_deg * kDegree))};
}

io::Image image_of(const Pixels& picture, double scale) {
    io::Image image{picture.width,
                    picture.height,
                    {{"R", {}}, {"G", {}}, {"B", {}}},
                    {{"nacre:study", "flakes"}}};
    for (std::size_t i = 0; i < picture.rgb.size(); ++i)
        image.channels[i % 3].pixels.push_back(static_cast<float>(scale * picture.rgb[i]));
    return image;
}

std::string fingerprint(const CloseUpJob& job) {
    const json description = {
        {"version", version()}, {"surface", job.surface}, {"pixel_mm", job.pixel_mm},
        {"pixels", job.pixels}, {"samples", job.samples}, {"seed", job.seed},
        {"eye_deg", kEye_deg},  {"lamp_deg", kLamp_deg},  {"lamp_size_deg", kLampSize_deg}};
    return sha256_hex(description.dump());
}

}  // namespace

double panel_side_mm(double pixel_mm, int pixels) {
    return 1.2 * pixel_mm * pixels / std::cos(kEye_deg * kDegree);
}

render::SceneDescription close_up_scene(double pixel_mm, int pixels) {
    const double view_mm = pixel_mm * pixels;
    // So far away that directions over the view differ by less than a fifth of a degree.
    const double distance_mm = std::max(100.0, 300 * view_mm);
    render::SceneDescription scene;
    scene.name = "close-up";
    scene.camera.position_mm = towards(kEye_deg, distance_mm);
    scene.camera.up = {0, 1, 0};
    scene.camera.vertical_fov_deg = 2 * std::atan(0.5 * view_mm / distance_mm) / kDegree;
    scene.materials["paint"] = render::PaintMaterial{};
    const double side = panel_side_mm(pixel_mm, pixels);
    scene.shapes.push_back({render::FlatPanel{side, side}, "paint", {}});
    render::RectangleLight lamp;
    lamp.center_mm = towards(-kLamp_deg, distance_mm);
    lamp.width_mm = lamp.height_mm = 2 * distance_mm * std::tan(0.5 * kLampSize_deg * kDegree);
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
    const fs::path record_file = folder_ / "pictures" / (job.key + ".json");
    const std::string print = fingerprint(job);
    if (!find_record(record_file, print, {exr}).is_null()) {
        const io::Image image = io::read_image(exr);
        return {image.width, image.height, io::interleaved_rgb(image, exr.string())};
    }
    check_own(record_file, exr);
    check_own(exr, record_file);
    Pixels pixels{job.pixels, job.pixels, {}};
    stage_(job.title, [&](const Progress& progress) {
        const render::Scene scene(close_up_scene(job.pixel_mm, job.pixels),
                                  {{"paint", surface(progress)}});
        render::RenderOptions options;
        options.width = options.height = job.pixels;
        options.samples_per_pixel = job.samples;
        options.seed = job.seed;
        render::RenderResult result = render::render(scene, options, progress);
        if (!result.complete) throw Interrupted("stopped");
        pixels.rgb = std::move(result.rgb);
        io::write_exr(exr, image_of(pixels, 1));
        write_record(record_file, {{"title", job.title}}, print, {exr});
    });
    return pixels;
}

std::string CloseUps::png(const Pixels& picture, double mean, const std::string& key) const {
    const fs::path file = folder_ / "pictures" / (key + ".png");
    check_own(file);
    io::write_png(file, image_of(picture, 0.3 / mean));
    return read_file(file);
}

}  // namespace nacre::study
