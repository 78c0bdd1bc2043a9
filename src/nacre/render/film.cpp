#include "nacre/render/film.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "nacre/core/lanes.h"
#include "nacre/spectra/colour.h"

namespace nacre::render {
namespace {

/// XYZ of D65 of luminance 1.
Vec3d white_xyz() { return spectra::linear_rec709_to_xyz({1, 1, 1}); }

float estimate(const XyzWeights& weights, int channel, FloatLanes radiance) {
    return lane_sum(weights[channel] * radiance);
}

/// Light that sums may hold at each wavelength: the perfect diffuser in full light has 1. The XYZ of
/// it and of differences stay below what LightSum takes.
constexpr float kMaxLight = 0x1p53f;

bool can_be_summed(const FloatLanes& light) {
    return count_lanes(max_lanes(light, -light) < kMaxLight) == kLanes;
}

template <class T>
void prefetch_one(const T& of) {
    // The first and the last byte: it may lie across two lines of the cache.
    __builtin_prefetch(&of, 1);
    __builtin_prefetch(reinterpret_cast<const char*>(&of + 1) - 1, 1);
}

}  // namespace

Film::Film(FilmSums sums)
    : sums_(std::move(sums)), bins_(static_cast<int>(sums_.passes.bin_weights.size())) {
    ahead_.resize(sums_.pixels());
}

void Film::begin_pass(const Pass& pass, bool with_albedo) {
    with_albedo_ = with_albedo;
    with_current_ = sums_.passes;
    ++with_current_.count;
    for (int c = 0; c < 3; ++c) {
        const float d65 = estimate(pass.xyz_weights, c, pass.d65);
        with_current_.d65[c].add(d65);
        if (with_albedo) with_current_.albedo_d65[c].add(d65);
    }
    if (bins_ == 0) return;
    for (int i = 0; i < kLanes; ++i) {
        // Position among the bins' centres; beyond the outermost ones all goes to the outermost.
        const double x = std::clamp(
            (pass.wavelengths_nm[i] - kFilmFirst_nm) / (kFilmLast_nm - kFilmFirst_nm) * bins_ - 0.5,
            0.0, bins_ - 1.0);
        const int bin = std::min(static_cast<int>(x), std::max(bins_ - 2, 0));
        const auto next = static_cast<float>(x - bin);
        splats_[i] = {bin, 1 - next, next};
        with_current_.bin_weights[bin].add(splats_[i].weight);
        if (bin + 1 < bins_) with_current_.bin_weights[bin + 1].add(splats_[i].next_weight);
    }
}

void Film::prefetch(std::size_t pixel) const {
    prefetch_one(sums_.xyz[pixel]);
    prefetch_one(sums_.normal[pixel]);
    __builtin_prefetch(&sums_.met[pixel], 1);
    if (with_albedo_) prefetch_one(sums_.albedo[pixel]);
    if (!sums_.sparkle.empty()) prefetch_one(sums_.sparkle[pixel]);
}

void Film::add(std::size_t pixel, const Pass& pass, const PathLight& path) {
    ahead_[pixel] = 1;
    const bool with_sparkle = !sums_.sparkle.empty();
    if (!can_be_summed(path.radiance) || (with_sparkle && !can_be_summed(path.smooth))) {
        ++sums_.invalid[pixel];
        return;
    }
    for (int c = 0; c < 3; ++c) {
        sums_.xyz[pixel][c].add(estimate(pass.xyz_weights, c, path.radiance));
        if (with_sparkle) {
            sums_.sparkle[pixel][c].add(estimate(pass.xyz_weights, c, path.radiance - path.smooth));
        }
    }
    if (bins_ > 0) {
        LightSum* bins = &sums_.spectral[pixel * bins_];
        for (int i = 0; i < kLanes; ++i) {
            const Splat& s = splats_[i];
            bins[s.bin].add(s.weight * path.radiance[i]);
            if (s.next_weight > 0) bins[s.bin + 1].add(s.next_weight * path.radiance[i]);
        }
    }
    if (!path.met_surface) return;
    ++sums_.met[pixel];
    for (int c = 0; c < 3; ++c) {
        if (std::abs(path.normal[c]) <= 1) sums_.normal[pixel][c].add(path.normal[c]);
    }
    if (with_albedo_ && can_be_summed(path.albedo)) {
        for (int c = 0; c < 3; ++c) {
            sums_.albedo[pixel][c].add(estimate(pass.xyz_weights, c, path.albedo * pass.d65));
        }
    }
}

void Film::end_pass() {
    sums_.passes = with_current_;
    std::fill(ahead_.begin(), ahead_.end(), std::uint8_t{0});
}

Vec3d Film::colour(const SumTriple<LightSum>& sum, const SumTriple<LightSum>& d65) const {
    static const Vec3d white = white_xyz();
    const Vec3d light = sum.value(), of_white = d65.value();
    Vec3d xyz{};
    for (int c = 0; c < 3; ++c) xyz[c] = of_white[c] > 0 ? light[c] / of_white[c] * white[c] : 0;
    return spectra::xyz_to_linear_rec709(xyz);
}

RenderResult Film::develop() const {
    RenderResult result;
    result.width = sums_.width;
    result.height = sums_.height;
    result.samples = sums_.passes.count;
    const std::size_t pixels = sums_.pixels();
    result.rgb.resize(3 * pixels);
    result.albedo.resize(3 * pixels);
    result.normal.resize(3 * pixels);
    result.alpha.resize(pixels);
    result.sparkle.resize(3 * sums_.sparkle.size());
    for (std::size_t p = 0; p < pixels; ++p) {
        const PassSums& passes = ahead_[p] ? with_current_ : sums_.passes;
        const double per_pass = passes.count > 0 ? 1.0 / passes.count : 0;
        const Vec3d rgb = colour(sums_.xyz[p], passes.d65);
        const Vec3d albedo = colour(sums_.albedo[p], passes.albedo_d65);
        const Vec3d normal = sums_.normal[p].value();
        for (int c = 0; c < 3; ++c) {
            result.rgb[3 * p + c] = static_cast<float>(rgb[c]);
            // A saturated paint's colour may lie outside Rec. 709; denoisers want [0, 1].
            result.albedo[3 * p + c] = static_cast<float>(std::clamp(albedo[c], 0.0, 1.0));
            result.normal[3 * p + c] = static_cast<float>(per_pass * normal[c]);
        }
        if (!sums_.sparkle.empty()) {
            const Vec3d sparkle = colour(sums_.sparkle[p], passes.d65);
            for (int c = 0; c < 3; ++c) result.sparkle[3 * p + c] = static_cast<float>(sparkle[c]);
        }
        result.alpha[p] = static_cast<float>(per_pass * sums_.met[p]);
    }
    result.invalid_paths = std::accumulate(sums_.invalid.begin(), sums_.invalid.end(), 0L);

    result.spectral.resize(sums_.spectral.size());
    for (int b = 0; b < bins_; ++b) {
        result.bin_centres_nm.push_back(kFilmFirst_nm +
                                        (b + 0.5) * (kFilmLast_nm - kFilmFirst_nm) / bins_);
    }
    develop_bins(sums_.passes, false, result);
    develop_bins(with_current_, true, result);
    return result;
}

/// The spectra of the pixels that have had these passes.
void Film::develop_bins(const PassSums& passes, bool ahead, RenderResult& result) const {
    std::vector<double> weights;
    for (const LightSum& weight : passes.bin_weights) weights.push_back(weight.value());
    for (std::size_t b = 0; b < weights.size(); ++b) {
        // With fewer wavelengths than bins some bins have none: they take the value of the nearest
        // bin that has one.
        std::size_t source = b;
        for (std::size_t step = 1; weights[source] <= 0 && step < weights.size(); ++step) {
            if (b >= step && weights[b - step] > 0) source = b - step;
            if (b + step < weights.size() && weights[b + step] > 0) source = b + step;
        }
        if (weights[source] <= 0) continue;
        const double scale = 1 / weights[source];
        for (std::size_t p = 0; p < ahead_.size(); ++p) {
            if ((ahead_[p] != 0) != ahead) continue;
            result.spectral[p * bins_ + b] =
                static_cast<float>(scale * sums_.spectral[p * bins_ + source].value());
        }
    }
}

}  // namespace nacre::render
