#include "nacre/render/film.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "nacre/spectra/colour.h"

namespace nacre::render {
namespace {

/// XYZ of D65 of luminance 1.
Vec3d white_xyz() { return spectra::linear_rec709_to_xyz({1, 1, 1}); }

double estimate(const XyzWeights& weights, int channel, FloatLanes radiance) {
    return lane_sum(weights[channel] * radiance);
}

}  // namespace

Film::Film(int width, int height, int spectral_bins, bool with_sparkle)
    : width_(width), height_(height), bins_(spectral_bins) {
    const std::size_t pixels = static_cast<std::size_t>(width) * height;
    xyz_.resize(pixels);
    albedo_.resize(pixels);
    normal_.resize(pixels);
    met_.resize(pixels);
    if (with_sparkle) sparkle_.resize(pixels);
    invalid_.resize(pixels);
    ahead_.resize(pixels);
    done_.bin_weights.resize(bins_);
    spectral_.resize(pixels * bins_);
}

void Film::begin_pass(const Pass& pass, bool with_albedo) {
    with_albedo_ = with_albedo;
    with_current_ = done_;
    ++with_current_.count;
    for (int c = 0; c < 3; ++c) {
        const double d65 = estimate(pass.xyz_weights, c, pass.d65);
        with_current_.d65[c] += d65;
        if (with_albedo) with_current_.albedo_d65[c] += d65;
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
        with_current_.bin_weights[bin] += splats_[i].weight;
        if (bin + 1 < bins_) with_current_.bin_weights[bin + 1] += splats_[i].next_weight;
    }
}

void Film::add(std::size_t pixel, const Pass& pass, const PathLight& path) {
    ahead_[pixel] = 1;
    Vec3d xyz, sparkle;
    for (int c = 0; c < 3; ++c) {
        xyz[c] = estimate(pass.xyz_weights, c, path.radiance);
        if (!sparkle_.empty()) {
            sparkle[c] = estimate(pass.xyz_weights, c, path.radiance - path.smooth);
        }
    }
    if (!std::isfinite(xyz[0] + xyz[1] + xyz[2] + sparkle[0] + sparkle[1] + sparkle[2])) {
        ++invalid_[pixel];
        return;
    }
    xyz_[pixel] += xyz;
    if (!sparkle_.empty()) sparkle_[pixel] += sparkle;
    if (bins_ > 0) {
        float* bins = &spectral_[pixel * bins_];
        for (int i = 0; i < kLanes; ++i) {
            const Splat& s = splats_[i];
            bins[s.bin] += s.weight * path.radiance[i];
            if (s.next_weight > 0) bins[s.bin + 1] += s.next_weight * path.radiance[i];
        }
    }
    if (!path.met_surface) return;
    met_[pixel] += 1;
    normal_[pixel] = normal_[pixel] + path.normal;
    if (with_albedo_) {
        for (int c = 0; c < 3; ++c) {
            const double albedo = estimate(pass.xyz_weights, c, path.albedo * pass.d65);
            if (std::isfinite(albedo)) albedo_[pixel][c] += albedo;
        }
    }
}

void Film::end_pass() {
    done_ = with_current_;
    std::fill(ahead_.begin(), ahead_.end(), std::uint8_t{0});
}

Vec3d Film::colour(const Vec3d& sum, const Vec3d& d65) const {
    static const Vec3d white = white_xyz();
    Vec3d xyz{};
    for (int c = 0; c < 3; ++c) xyz[c] = d65[c] > 0 ? sum[c] / d65[c] * white[c] : 0;
    return spectra::xyz_to_linear_rec709(xyz);
}

RenderResult Film::develop() const {
    RenderResult result;
    result.width = width_;
    result.height = height_;
    result.samples = done_.count;
    const std::size_t pixels = xyz_.size();
    result.rgb.resize(3 * pixels);
    result.albedo.resize(3 * pixels);
    result.normal.resize(3 * pixels);
    result.alpha.resize(pixels);
    result.sparkle.resize(3 * sparkle_.size());
    for (std::size_t p = 0; p < sparkle_.size(); ++p) {
        const auto sparkle = colour(sparkle_[p], (ahead_[p] ? with_current_ : done_).d65);
        for (int c = 0; c < 3; ++c) result.sparkle[3 * p + c] = static_cast<float>(sparkle[c]);
    }
    for (std::size_t p = 0; p < pixels; ++p) {
        const Passes& passes = ahead_[p] ? with_current_ : done_;
        const float per_pass = passes.count > 0 ? 1.0f / static_cast<float>(passes.count) : 0;
        const auto rgb = colour(xyz_[p], passes.d65);
        const auto albedo = colour(albedo_[p], passes.albedo_d65);
        const Vec3f normal = per_pass * normal_[p];
        for (int c = 0; c < 3; ++c) {
            result.rgb[3 * p + c] = static_cast<float>(rgb[c]);
            // A saturated paint's colour may lie outside Rec. 709; denoisers want [0, 1].
            result.albedo[3 * p + c] = static_cast<float>(std::clamp(albedo[c], 0.0, 1.0));
        }
        result.normal[3 * p] = normal.x;
        result.normal[3 * p + 1] = normal.y;
        result.normal[3 * p + 2] = normal.z;
        result.alpha[p] = per_pass * met_[p];
    }
    result.invalid_paths = std::accumulate(invalid_.begin(), invalid_.end(), 0L);

    result.spectral.resize(spectral_.size());
    for (int b = 0; b < bins_; ++b) {
        result.bin_centres_nm.push_back(kFilmFirst_nm +
                                        (b + 0.5) * (kFilmLast_nm - kFilmFirst_nm) / bins_);
    }
    develop_bins(done_, false, result);
    develop_bins(with_current_, true, result);
    return result;
}

/// The spectra of the pixels that have had these passes.
void Film::develop_bins(const Passes& passes, bool ahead, RenderResult& result) const {
    const std::vector<double>& weights = passes.bin_weights;
    for (std::size_t b = 0; b < weights.size(); ++b) {
        // With fewer wavelengths than bins some bins have none: they take the value of the nearest
        // bin that has one.
        std::size_t source = b;
        for (std::size_t step = 1; weights[source] <= 0 && step < weights.size(); ++step) {
            if (b >= step && weights[b - step] > 0) source = b - step;
            if (b + step < weights.size() && weights[b + step] > 0) source = b + step;
        }
        if (weights[source] <= 0) continue;
        const auto scale = static_cast<float>(1 / weights[source]);
        for (std::size_t p = 0; p < ahead_.size(); ++p) {
            if ((ahead_[p] != 0) != ahead) continue;
            result.spectral[p * bins_ + b] = scale * spectral_[p * bins_ + source];
        }
    }
}

}  // namespace nacre::render
