#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/core/progress.h"
#include "nacre/render/film_sums.h"
#include "nacre/render/integrator.h"
#include "nacre/render/scene.h"

// The picture of a scene by spectral path tracing.

namespace nacre::render {

struct RenderOptions {
    int width = 512;             ///< pixels, [1, io::kMaxPixelsPerSide]
    int height = 512;            ///< pixels, [1, io::kMaxPixelsPerSide]
    int samples_per_pixel = 64;  ///< [1, 2^24]
    std::uint64_t seed = 0;
    int max_depth = 8;  ///< surface reflections along a path, [1, 1000]
    /// Side of the piece of surface that each sample shows where single flakes do, [0, 1000] pixels.
    /// 0: flakes that can be sampled one by one are (docs/nacre-model.md), and where they cannot,
    /// as those of surfaces seen in a mirror, default_footprint_pixels().
    double footprint_pixels = 0;
    bool sparkle = false;  ///< RenderResult::sparkle is asked for
    bool noise =
        false;  ///< RenderResult::noise is asked for; from 64 x 64 pixels it takes a 64th more
    int spectral_bins = 0;  ///< bins of the spectral film over 400-700 nm, [0, 300]; 0: none;
                            ///< times the pixels at most 2^32

    friend bool operator==(const RenderOptions&, const RenderOptions&) = default;
};

/// 1.5 / sqrt(samples_per_pixel), at most 1.
///
/// The samples of a pixel lie under its filter, a tent two pixels wide, which weighs as much as
/// (Int t)^2 / Int t^2 = 1.5^2 pixels of even weight: such patches cover it once. With patches that
/// divide one pixel only between them, many flakes would be missed, and the noise of a metallic
/// panel in the sun be 62 instead of 41 % of its light (32 samples); the contrast of the picture is
/// the same, as the filter is far wider than a patch. The more samples, the smaller the patches:
/// the picture converges to that of points.
double default_footprint_pixels(int samples_per_pixel);

/// One of `count` parts of a picture's samples, which are alike in number but for one sample.
struct Shard {
    int number = 1;  ///< [1, count]
    int count = 1;   ///< [1, RenderOptions::samples_per_pixel]

    friend bool operator==(const Shard&, const Shard&) = default;
};

/// What a shard of the samples adds to a picture, and all of them make the whole of.
struct RenderSums {
    RenderSums() = default;
    /// Of no samples.
    /// @param options  as check() takes them
    explicit RenderSums(const RenderOptions& options);

    FilmSums picture;
    /// Of the pixels that are rendered twice for RenderResult::noise; none unless asked for.
    std::optional<FilmSums> probe;
    double seconds = 0;  ///< wall-clock time

    /// @param other  of the same options, and of other samples
    void add(const RenderSums& other);

    friend bool operator==(const RenderSums&, const RenderSums&) = default;
};

/// A picture, row-major from the top left. Radiance is linear; luminance 1 is the radiance of an
/// emitter of scale 1 (scene.h).
struct RenderResult {
    int width = 0, height = 0;
    std::vector<float> rgb;     ///< 3 per pixel: linear Rec. 709, may be out of gamut
    std::vector<float> albedo;  ///< 3 per pixel: albedo of the first surface under D65; 0: none
    std::vector<float> normal;  ///< 3 per pixel: mean shading normal of the first surface
    std::vector<float> alpha;   ///< 1 per pixel: fraction of the samples that met a surface
    /// 3 per pixel, linear Rec. 709; empty unless asked for. The light of single flakes less that
    /// of their mean, so that it is negative where they are few or turned away, and 0 on average.
    /// rgb - sparkle is the picture of the mean, which may be denoised without loss of flakes.
    std::vector<float> sparkle;
    std::vector<float> spectral;  ///< bins per pixel: mean spectral radiance about each centre
    std::vector<double> bin_centres_nm;
    int samples = 0;  ///< per pixel, finished
    /// Standard error of a pixel's luminance, root mean square over the picture, over its mean
    /// luminance; none unless asked for, and of pictures that were stopped. See noise_of().
    std::optional<double> noise = {};
    /// Paths whose light was not finite, or beyond 2^53 times the perfect diffuser's in full light,
    /// taken as black: always 0 unless a surface or a light is at fault.
    long invalid_paths = 0;
    double seconds = 0;    ///< wall-clock time, of shards their sum
    bool complete = true;  ///< false: stopped by `progress`; a valid picture of `samples` samples
};

/// What render() refuses, before any work.
/// @throws DomainError naming an option out of range; Error if the machine has less memory than the
///         picture takes until it is written
void check(const RenderOptions& options);
/// The same of one shard.
/// @throws DomainError "shard = ..." besides
void check(const RenderOptions& options, const Shard& shard);

/// Renders by unidirectional path tracing with multiple importance sampling. Uses the threads of
/// the caller's oneTBB arena; for a given seed the result is the same, bit for bit, however many
/// there are.
///
/// @param progress  may be empty; asked several times a second
/// @throws DomainError, Error as check()
RenderResult render(const Scene& scene, const RenderOptions& options,
                    const Progress& progress = {});

/// After each multiple of so many samples as large a fraction of those rendered has drawn from flakes
/// (FlakeStratum) as of all. A picture of fewer has up to so many times their light.
int flake_sampling_stride(int samples_per_pixel);

/// How many samples a pixel has of a shard.
int samples_of(const RenderOptions& options, const Shard& shard);

/// Renders one shard of a picture's samples. The sums of all shards, added in any order, develop()
/// to the picture that render() makes, bit for bit in every channel: each sample is the one that it
/// would be there, with the flakes of its part of the pixel, and sums of light are exact
/// (core/reproducible_sum.h).
/// @throws DomainError, Error as check(); Stopped if `progress` asks to stop
RenderSums render_shard(const Scene& scene, const RenderOptions& options, const Shard& shard,
                        const Progress& progress = {});

/// The picture of all its samples.
/// @param options  with which they were rendered
RenderResult develop(RenderSums whole, const RenderOptions& options);

/// The noise that a picture would have (RenderResult::noise): some of its pixels, one of 64 where
/// there are many, are rendered twice with seeds of their own, and half the mean square of their
/// differences is the variance. Without bias whatever the paths and their sampler do; wavelengths,
/// which all pixels share, aside. Light that few paths find may escape it, as it does the picture.
/// @throws as render(); Stopped if `progress` asks to stop
double noise_of(const Scene& scene, const RenderOptions& options, const Progress& progress = {});

/// A power of two: the fewest samples a pixel, of 16 or more, with which noise_of() is at most
/// `noise`, or `most` if they would have to be more.
/// @param noise  in kNoiseRange
/// @throws as noise_of(); DomainError if `noise` is out of range
int samples_for_noise(const Scene& scene, RenderOptions options, double noise, int most,
                      const Progress& progress = {});
inline constexpr Range kNoiseRange{1e-4, 10};

/// As render(), with a choice of estimators of direct light, so that tests can compare them.
RenderResult render_with(const Scene& scene, const RenderOptions& options, DirectLight direct_light,
                         const Progress& progress = {});

}  // namespace nacre::render
