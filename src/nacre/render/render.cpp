#include "nacre/render/render.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cmath>
#include <optional>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/core/memory.h"
#include "nacre/core/parallel.h"
#include "nacre/core/random.h"
#include "nacre/io/image.h"
#include "nacre/render/camera.h"
#include "nacre/render/film.h"
#include "nacre/spectra/rgb.h"

namespace nacre::render {
namespace {

/// Denoisers need little more than an antialiased albedo, and it costs a call per path.
constexpr int kAlbedoPasses = 16;
/// Side of the square of pixels that is one piece of work: neighbouring rays share their way
/// through the ray-tracing structure and its cache lines.
constexpr int kTile = 16;

// Bytes a pixel: sums and the developed picture, or that and the channels of its image.
constexpr double kBytesPerPixel = 180, kSparkleBytesPerPixel = 75, kBytesPerBin = 21;

}  // namespace

void check(const RenderOptions& options) {
    require_in_range(options.width, 1, io::kMaxPixelsPerSide, "width in pixels");
    require_in_range(options.height, 1, io::kMaxPixelsPerSide, "height in pixels");
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

void check(const RenderOptions& options, const Shard& shard) {
    check(options);
    if (shard.count < 1 || shard.count > options.samples_per_pixel || shard.number < 1 ||
        shard.number > shard.count) {
        throw DomainError(
            fmt::format("shard = {}/{}: must be one from 1/N to N/N, with N from 1 to the {} "
                        "samples of a pixel",
                        shard.number, shard.count, options.samples_per_pixel));
    }
}

namespace {

/// A tent of half-width 1 pixel about 0, from a number in [0, 1).       [ernst-2006]
/// Drawing positions by the filter, not weighting by it, lets each pixel keep its own sums.
float tent(float u) { return u < 0.5f ? std::sqrt(2 * u) - 1 : 1 - std::sqrt(2 - 2 * u); }

/// How the samples of a pixel divide what it sees: see FlakeStratum.
///
/// The first two numbers of a pixel's samples are a (0,2)-sequence: of any aligned 2^k samples one
/// lies in each of 2^k equal boxes of the unit square. The tent takes boxes to rectangles that
/// cover the pixel's filter, each with the same weight. So the first 2^k samples draw from
/// the flakes of their own rectangles, and the others need not look.
class FlakeStrata {
 public:
    explicit FlakeStrata(int samples_per_pixel) {
        // A quarter of the samples, where that leaves enough parts.
        constexpr int kEnough = 4, kFewer = 2;
        int log2 = 0;
        while (2 << log2 <= samples_per_pixel) ++log2;
        log2 = std::max(std::min(log2, kEnough), log2 - kFewer);
        columns_ = sides(1 << ((log2 + 1) / 2));
        rows_ = sides(1 << (log2 / 2));
        samples_per_stratum_ = static_cast<float>(samples_per_pixel) / static_cast<float>(count());
    }

    /// How many samples draw from flakes: the first ones.
    std::size_t count() const { return columns_.size() * rows_.size(); }

    int stride_of(int samples_per_pixel) const {
        return samples_per_pixel / static_cast<int>(count());
    }

    /// The sample that a pass takes: those that draw from flakes evenly between the others, so that a picture
    /// that is stopped has about as much of the flakes' light as of the rest.
    std::uint32_t sample_of_pass(int pass, int samples_per_pixel) const {
        const int strata = static_cast<int>(count()), stride = stride_of(samples_per_pixel);
        const int before = std::min(strata, (pass + stride - 1) / stride);  // of them
        const bool first = pass % stride == 0 && pass / stride < strata;
        return static_cast<std::uint32_t>(first ? before : strata + pass - before);
    }

    /// Of a sample whose place in the filter is tent(u.x), tent(u.y).
    FlakeStratum stratum(Vec2f u, Vec2f place, std::uint32_t sample_index) const {
        const Side& x = columns_[static_cast<std::size_t>(u.x * columns_.size())];
        const Side& y = rows_[static_cast<std::size_t>(u.y * rows_.size())];
        return {.place = place,
                .middle = {x.middle, y.middle},
                .size = {x.length, y.length},
                .tilt = {x.tilt, y.tilt},
                .samples_per_stratum = sample_index < count() ? samples_per_stratum_ : 0.0f};
    }

 private:
    struct Side {
        float middle, length, tilt;
    };
    static std::vector<Side> sides(int parts) {
        std::vector<Side> all;
        for (int i = 0; i < parts; ++i) {
            const float begin = tent(static_cast<float>(i) / static_cast<float>(parts));
            const float end = tent(static_cast<float>(i + 1) / static_cast<float>(parts));
            const float middle = 0.5f * (begin + end), length = end - begin;
            // The tent falls off on either side of its middle; a single part holds both.
            const float fall = parts == 1 ? 0.0f : 0.5f * length / (1 - std::abs(middle));
            all.push_back({middle, length, middle < 0 ? fall : -fall});
        }
        return all;
    }
    std::vector<Side> columns_, rows_;
    float samples_per_stratum_;
};

/// The pixel of the whole picture that a column, or a row, of one with every `stride`-th is.
int pixel_of(int taken, int stride) { return stride / 2 + stride * taken; }

/// How many columns, or rows, it has.
int taken_of(int pixels, int stride) { return (pixels + stride - 1 - stride / 2) / stride; }

/// Renders a picture pass by pass, or every `stride`-th of its columns and rows.
class Renderer {
 public:
    Renderer(const CompiledScene& scene, const RenderOptions& options, DirectLight direct_light,
             int stride = 1)
        : scene_(scene),
          options_(options),
          camera_(scene.camera, options.width, options.height),
          strata_(options.samples_per_pixel),
          stride_(stride),
          columns_(taken_of(options.width, stride)),
          rows_(taken_of(options.height, stride)),
          film_(FilmSums(columns_, rows_, options.spectral_bins, options.sparkle)),
          tiles_across_((columns_ + kTile - 1) / kTile),
          tiles_down_((rows_ + kTile - 1) / kTile) {
        path_options_.max_depth = options.max_depth;
        path_options_.direct_light = direct_light;
        path_options_.smooth = options.sparkle;
        path_options_.sample_flakes = options.footprint_pixels == 0;
        for (const auto& material : scene.materials) {
            flakes_show_ |=
                material->surface_coordinates() == bsdf::SurfaceCoordinates::object_space;
        }
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

    /// @param number  in [0, samples per pixel)
    std::unique_ptr<const Pass> pass(const CompiledScene& scene, int number) const {
        const auto count = static_cast<std::uint32_t>(options_.samples_per_pixel);
        const auto of_flakes = flakes_show_ ? static_cast<std::uint32_t>(strata_.count()) : 0;
        const std::uint32_t sample =
            flakes_show_ ? strata_.sample_of_pass(number, options_.samples_per_pixel)
                         : static_cast<std::uint32_t>(number);
        // The light of flakes, which come from the first samples alone, has wavelengths as even as the rest.
        return std::make_unique<const Pass>(
            scene, sample,
            sample < of_flakes ? film_wavelengths(sample, of_flakes)
                               : film_wavelengths(sample - of_flakes, count - of_flakes));
    }
    RenderResult develop() const { return film_.develop(); }
    FilmSums take_sums() { return film_.take_sums(); }

 private:
    /// @return whether the whole tile was done
    bool run_tile(const Pass& pass, int tile, bsdf::PatchMemory& memory, SharedProgress& counter) {
        const int x0 = tile % tiles_across_ * kTile;
        const int y0 = tile / tiles_across_ * kTile;
        for (int row = y0; row < std::min(y0 + kTile, rows_); ++row) {
            for (int column = x0; column < std::min(x0 + kTile, columns_); ++column) {
                if (!counter.keep_going()) return false;
                const int x = pixel_of(column, stride_), y = pixel_of(row, stride_);
                const auto pixel = static_cast<std::uint32_t>(y) * options_.width + x;
                const auto taken = static_cast<std::size_t>(row) * columns_ + column;
                film_.prefetch(taken);
                const PathSampler sampler(options_.seed, pixel, pass.sample_index);
                const auto u = sampler.draw(0);
                const Vec2f place = {tent(u[0]), tent(u[1])};
                const CameraRay ray = camera_(static_cast<float>(x) + 0.5f + place.x,
                                              static_cast<float>(y) + 0.5f + place.y, {u[2], u[3]});
                const FlakeStratum stratum =
                    strata_.stratum({u[0], u[1]}, place, pass.sample_index);
                try {
                    film_.add(
                        taken, pass,
                        trace_path(scene_, pass, sampler, ray, stratum, path_options_, memory));
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
    FlakeStrata strata_;
    bool flakes_show_ = false;
    int stride_, columns_, rows_;
    Film film_;
    int tiles_across_, tiles_down_;
};

}  // namespace

double default_footprint_pixels(int samples_per_pixel) {
    return std::min(1.0, 1.5 / std::sqrt(static_cast<double>(samples_per_pixel)));
}

namespace {

/// [begin, end) of a picture's passes: its samples, in the order of the work.
struct PassRange {
    int begin = 0, end = 0;
    int count() const { return end - begin; }
};

/// Passes that follow each other: those that draw from flakes, which take longer, are spread evenly.
PassRange passes_of(const RenderOptions& options, const Shard& shard) {
    const auto before = [&](int shards) {
        return static_cast<int>(std::int64_t{options.samples_per_pixel} * shards / shard.count);
    };
    return {before(shard.number - 1), before(shard.number)};
}

/// Takes renderers of pictures with as many samples through passes, together.
/// @return false if asked to stop
bool run_passes(const CompiledScene& scene, const std::vector<Renderer*>& renderers,
                PassRange range, SharedProgress& counter) {
    // Surfaces are bound for a few passes at a time, in parallel, each pass to its own wavelengths.
    constexpr int kPassesBound = 8;
    for (int first = range.begin; first < range.end; first += kPassesBound) {
        if (counter.stopped()) return false;
        std::vector<std::unique_ptr<const Pass>> passes(std::min(kPassesBound, range.end - first));
        try {
            parallel_for_ranges(0, passes.size(), 1, [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i) {
                    passes[i] = renderers[0]->pass(scene, first + static_cast<int>(i));
                }
            });
        } catch (const Stopped&) {
            return false;
        }
        for (auto& pass : passes) {
            for (Renderer* renderer : renderers) {
                if (!renderer->run(*pass, counter)) return false;
            }
            counter.add();
            pass.reset();
        }
    }
    return true;
}

/// So that at least 64 pixels are taken, and one of 64 of a large picture.
int noise_stride(const RenderOptions& options) {
    constexpr double kFewest = 64;
    const double pixels = static_cast<double>(options.width) * options.height;
    return std::clamp(static_cast<int>(std::sqrt(pixels / kFewest)), 1, 8);
}

/// The options with other random numbers, of the colour alone.
RenderOptions noise_options(RenderOptions options, int probe) {
    options.seed = hash_of(options.seed, 0x6e6f697365u, probe);
    options.sparkle = false;
    options.spectral_bins = 0;
    return options;
}

double luminance(const float* rgb) {
    return spectra::rec709_luminance<double>(rgb[0], rgb[1], rgb[2]);
}

/// From pairs of values of the same pixels by other random numbers; 0 of black pictures.
double noise_between(const std::vector<std::array<double, 2>>& pairs) {
    double sum = 0, squares = 0;
    for (const auto& [a, b] : pairs) {
        sum += 0.5 * (a + b);
        squares += 0.5 * (a - b) * (a - b);
    }
    const auto count = static_cast<double>(pairs.size());
    return sum > 0 ? std::sqrt(squares / count) / (sum / count) : 0;
}

}  // namespace

namespace {

/// A picture and, where its noise is asked for, its second rendering of some pixels.
class Rendering {
 public:
    Rendering(const CompiledScene& scene, const RenderOptions& options, DirectLight direct_light)
        : scene_(scene), picture_(scene, options, direct_light) {
        if (options.noise) {
            probe_.emplace(scene, noise_options(options, 0), direct_light, noise_stride(options));
        }
    }

    /// @return false if asked to stop
    bool run(PassRange range, const Progress& progress) {
        std::vector<Renderer*> renderers = {&picture_};
        if (probe_) renderers.push_back(&*probe_);
        SharedProgress counter(progress, range.count());
        const bool done = run_passes(scene_, renderers, range, counter);
        seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
        return done;
    }

    /// Of passes that are all done.
    RenderSums take_sums() {
        RenderSums sums;
        sums.picture = picture_.take_sums();
        sums.seconds = seconds_;
        if (probe_) sums.probe = probe_->take_sums();
        return sums;
    }
    /// What there is of a picture that was stopped.
    RenderResult develop_partial() const {
        RenderResult result = picture_.develop();
        result.complete = false;
        result.seconds = seconds_;
        return result;
    }

 private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    const CompiledScene& scene_;
    Renderer picture_;
    std::optional<Renderer> probe_;
    double seconds_ = 0;
};

/// Of a picture and its probe.
double noise_against(const RenderResult& picture, const RenderResult& probe, int stride) {
    std::vector<std::array<double, 2>> pairs;
    for (int row = 0; row < probe.height; ++row) {
        for (int column = 0; column < probe.width; ++column) {
            const auto taken = static_cast<std::size_t>(row) * probe.width + column;
            const auto pixel = static_cast<std::size_t>(pixel_of(row, stride)) * picture.width +
                               pixel_of(column, stride);
            pairs.push_back({luminance(&picture.rgb[3 * pixel]), luminance(&probe.rgb[3 * taken])});
        }
    }
    return noise_between(pairs);
}

}  // namespace

RenderSums::RenderSums(const RenderOptions& options)
    : picture(options.width, options.height, options.spectral_bins, options.sparkle) {
    if (!options.noise) return;
    const int stride = noise_stride(options);
    const RenderOptions of_probe = noise_options(options, 0);
    probe.emplace(taken_of(options.width, stride), taken_of(options.height, stride),
                  of_probe.spectral_bins, of_probe.sparkle);
}

void RenderSums::add(const RenderSums& other) {
    picture.add(other.picture);
    if (probe) probe->add(*other.probe);
    seconds += other.seconds;
}

RenderResult develop(RenderSums whole, const RenderOptions& options) {
    RenderResult result = Film(std::move(whole.picture)).develop();
    if (whole.probe) {
        const RenderResult probe = Film(std::move(*whole.probe)).develop();
        result.noise = noise_against(result, probe, noise_stride(options));
    }
    result.seconds = whole.seconds;
    return result;
}

int flake_sampling_stride(int samples_per_pixel) {
    return FlakeStrata(samples_per_pixel).stride_of(samples_per_pixel);
}

int samples_of(const RenderOptions& options, const Shard& shard) {
    return passes_of(options, shard).count();
}

RenderSums render_shard(const Scene& scene, const RenderOptions& options, const Shard& shard,
                        const Progress& progress) {
    check(options, shard);
    Rendering rendering(scene.compiled(), options, DirectLight::combined);
    if (!rendering.run(passes_of(options, shard), progress)) {
        throw Stopped("the shard of the picture was stopped");
    }
    return rendering.take_sums();
}

RenderResult render_with(const Scene& scene, const RenderOptions& options, DirectLight direct_light,
                         const Progress& progress) {
    check(options);
    Rendering rendering(scene.compiled(), options, direct_light);
    const bool done = rendering.run({0, options.samples_per_pixel}, progress);
    return done ? develop(rendering.take_sums(), options) : rendering.develop_partial();
}

double noise_of(const Scene& scene, const RenderOptions& options, const Progress& progress) {
    check(options);
    Renderer a(scene.compiled(), noise_options(options, 0), DirectLight::combined,
               noise_stride(options));
    Renderer b(scene.compiled(), noise_options(options, 1), DirectLight::combined,
               noise_stride(options));
    SharedProgress counter(progress, options.samples_per_pixel);
    if (!run_passes(scene.compiled(), {&a, &b}, {0, options.samples_per_pixel}, counter)) {
        throw Stopped("the estimate of the noise was stopped");
    }
    const RenderResult first = a.develop(), second = b.develop();
    std::vector<std::array<double, 2>> pairs;
    for (std::size_t i = 0; i < first.rgb.size(); i += 3) {
        pairs.push_back({luminance(&first.rgb[i]), luminance(&second.rgb[i])});
    }
    return noise_between(pairs);
}

int samples_for_noise(const Scene& scene, RenderOptions options, double noise, int most,
                      const Progress& progress) {
    require_in_range(noise, kNoiseRange.lo, kNoiseRange.hi, "noise");
    require_in_range(most, 1, 1 << 24, "most samples per pixel");
    constexpr int kFewest = 16;
    for (int samples = std::min(kFewest, most); samples < most;
         samples = std::min(2 * samples, most)) {
        options.samples_per_pixel = samples;
        if (noise_of(scene, options, progress) <= noise) return samples;
    }
    return most;
}

RenderResult render(const Scene& scene, const RenderOptions& options, const Progress& progress) {
    return render_with(scene, options, DirectLight::combined, progress);
}

}  // namespace nacre::render
