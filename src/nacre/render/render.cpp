#include "nacre/render/render.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>

#include "nacre/core/error.h"
#include "nacre/core/memory.h"
#include "nacre/core/parallel.h"
#include "nacre/render/camera.h"
#include "nacre/render/film.h"

namespace nacre::render {
namespace {

/// Denoisers need little more than an antialiased albedo, and it costs a call per path.
constexpr int kAlbedoPasses = 16;
/// Side of the square of pixels that is one piece of work: neighbouring rays share their way
/// through the ray-tracing structure and its cache lines.
constexpr int kTile = 16;

// Bytes a pixel: sums and the developed picture, or that and the channels of its image.
constexpr double kBytesPerPixel = 120, kSparkleBytesPerPixel = 50, kBytesPerBin = 8.5;

}  // namespace

void check(const RenderOptions& options) {
    require_in_range(options.width, 1, 32768, "width in pixels");
    require_in_range(options.height, 1, 32768, "height in pixels");
    require_in_range(options.samples_per_pixel, 1, 1 << 24, "samples per pixel");
    require_in_range(options.max_depth, 1, 1000, "max depth");
    require_in_range(options.footprint_pixels, 0, 1000, "footprint in pixels");
    require_in_range(options.spectral_bins, 0, 300, "spectral bins");
    const double pixels = static_cast<double>(options.width) * options.height;
    require_in_range(pixels, 1, 1 << 27, "width x height in pixels");
    require_in_range(pixels * options.spectral_bins, 0, 0x1p32, "width x height x spectral bins");
    require_memory(pixels * (kBytesPerPixel + (options.sparkle ? kSparkleBytesPerPixel : 0.0) +
                             kBytesPerBin * options.spectral_bins),
                   fmt::format("a picture of {} x {} pixels with {} spectral bins", options.width,
                               options.height, options.spectral_bins),
                   "choose fewer pixels or bins");
}

namespace {

/// A tent of half-width 1 pixel about 0, from a number in [0, 1).       [ernst-2006]
/// Drawing positions by the filter, not weighting by it, lets each pixel keep its own sums.
float tent(float u) { return u < 0.5f ? std::sqrt(2 * u) - 1 : 1 - std::sqrt(2 - 2 * u); }

class Renderer {
 public:
    Renderer(const CompiledScene& scene, const RenderOptions& options, DirectLight direct_light)
        : scene_(scene),
          options_(options),
          camera_(scene.camera, options.width, options.height),
          film_(options.width, options.height, options.spectral_bins, options.sparkle),
          tiles_across_((options.width + kTile - 1) / kTile),
          tiles_down_((options.height + kTile - 1) / kTile) {
        path_options_.max_depth = options.max_depth;
        path_options_.direct_light = direct_light;
        path_options_.smooth = options.sparkle;
        path_options_.footprint_pixels = static_cast<float>(
            options.footprint_pixels > 0 ? options.footprint_pixels
                                         : default_footprint_pixels(options.samples_per_pixel));
    }

    /// @return whether the whole pass was done
    bool run(const Pass& pass, SharedProgress& counter) {
        std::atomic<bool> cut = false;
        path_options_.albedo = pass.sample_index < kAlbedoPasses;
        film_.begin_pass(pass, path_options_.albedo);
        parallel_for_ranges(0, static_cast<std::size_t>(tiles_across_) * tiles_down_, 1,
                            [&](std::size_t first, std::size_t last) {
                                bsdf::PatchMemory memory(pass.patch_memory_bytes);
                                for (std::size_t t = first; t < last && !cut; ++t) {
                                    if (!run_tile(pass, static_cast<int>(t), memory, counter)) {
                                        cut = true;
                                    }
                                }
                            });
        if (!cut) film_.end_pass();
        return !cut;
    }

    RenderResult develop() const { return film_.develop(); }

 private:
    /// @return whether the whole tile was done
    bool run_tile(const Pass& pass, int tile, bsdf::PatchMemory& memory, SharedProgress& counter) {
        const int x0 = tile % tiles_across_ * kTile;
        const int y0 = tile / tiles_across_ * kTile;
        for (int y = y0; y < std::min(y0 + kTile, options_.height); ++y) {
            for (int x = x0; x < std::min(x0 + kTile, options_.width); ++x) {
                if (!counter.ask()) return false;
                const auto pixel = static_cast<std::uint32_t>(y) * options_.width + x;
                const PathSampler sampler(options_.seed, pixel, pass.sample_index);
                const auto u = sampler.draw(0);
                const CameraRay ray =
                    camera_(static_cast<float>(x) + 0.5f + tent(u[0]),
                            static_cast<float>(y) + 0.5f + tent(u[1]), {u[2], u[3]});
                try {
                    film_.add(pixel, pass,
                              trace_path(scene_, pass, sampler, ray, path_options_, memory));
                } catch (const Stopped&) {
                    return false;
                }
            }
        }
        return true;
    }

    const CompiledScene& scene_;
    RenderOptions options_;
    PathOptions path_options_;
    CameraRays camera_;
    Film film_;
    int tiles_across_, tiles_down_;
};

}  // namespace

double default_footprint_pixels(int samples_per_pixel) {
    return std::min(1.0, 1.5 / std::sqrt(static_cast<double>(samples_per_pixel)));
}

RenderResult render_with(const Scene& scene, const RenderOptions& options, DirectLight direct_light,
                         const Progress& progress) {
    check(options);
    const auto start = std::chrono::steady_clock::now();
    Renderer renderer(scene.compiled(), options, direct_light);

    // Surfaces are bound for a few passes at a time, in parallel, each pass to its own wavelengths.
    constexpr int kPassesBound = 8;
    const int total = options.samples_per_pixel;
    SharedProgress counter(progress, total);
    bool go_on = true;
    for (int first = 0; first < total && go_on; first += kPassesBound) {
        std::vector<std::unique_ptr<const Pass>> passes(std::min(kPassesBound, total - first));
        try {
            parallel_for_ranges(0, passes.size(), 1, [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i) {
                    passes[i] = std::make_unique<const Pass>(scene.compiled(),
                                                             static_cast<std::uint32_t>(first + i));
                }
            });
        } catch (const Stopped&) {
            break;
        }
        for (std::size_t i = 0; i < passes.size() && go_on; ++i) {
            go_on = renderer.run(*passes[i], counter);
            if (go_on) counter.add();
            go_on = go_on && !counter.stopped();
            passes[i].reset();
        }
    }
    RenderResult result = renderer.develop();
    result.complete = result.samples == total;
    result.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return result;
}

RenderResult render(const Scene& scene, const RenderOptions& options, const Progress& progress) {
    return render_with(scene, options, DirectLight::combined, progress);
}

}  // namespace nacre::render
