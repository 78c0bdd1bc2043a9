#include "nacre/bsdf/materials/diffuse_picture.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

#include "nacre/bsdf/warp.h"
#include "nacre/core/error.h"
#include "nacre/spectra/rgb.h"

namespace nacre::bsdf {
namespace {

using Colour = std::array<float, 3>;

class BoundDiffusePicture final : public BoundBsdf {
 public:
    BoundDiffusePicture(std::shared_ptr<const DiffusePicture::Pixels> pixels,
                        const Wavelengths& wavelengths_nm)
        : pixels_(std::move(pixels)) {
        const auto& basis = spectra::linear_rec709_basis();
        for (int c = 0; c < 3; ++c) {
            basis_[c] =
                make_lanes([&](int i) { return static_cast<float>(basis[c](wavelengths_nm[i])); });
        }
        // In double precision: of millions of pixels single precision drops a tenth.
        std::array<double, 3> sum{};
        for (std::size_t i = 0; i < pixels_->rgb.size(); ++i) sum[i % 3] += pixels_->rgb[i];
        const double count = static_cast<double>(pixels_->rgb.size() / 3);
        Colour mean;
        for (int c = 0; c < 3; ++c) mean[c] = static_cast<float>(sum[c] / count);
        mean_ = spectrum(mean);
    }

    FloatLanes eval(Vec3f wi, Vec3f wo) const override { return value(mean_, wi, wo); }
    float pdf(Vec3f wi, Vec3f wo) const override {
        return wi.z > 0 && wo.z > 0 ? std::numbers::inv_pi_v<float> * wo.z : 0;
    }
    std::optional<BsdfSample> sample(Vec3f wi, float, Vec2f u) const override {
        return draw(mean_, wi, u);
    }
    BsdfValue evaluate_on(const Patch& patch, Vec3f wi, Vec3f wo) const override {
        return {value(reflectance(patch), wi, wo), pdf(wi, wo)};
    }
    std::optional<BsdfSample> sample_on(const Patch& patch, Vec3f wi, float,
                                        Vec2f u) const override {
        return draw(reflectance(patch), wi, u);
    }
    FloatLanes albedo(Vec3f wi) const override { return wi.z > 0 ? mean_ : FloatLanes{}; }

 private:
    static FloatLanes value(const FloatLanes& reflectance, Vec3f wi, Vec3f wo) {
        return wi.z > 0 && wo.z > 0 ? std::numbers::inv_pi_v<float> * reflectance : FloatLanes{};
    }
    static std::optional<BsdfSample> draw(const FloatLanes& reflectance, Vec3f wi, Vec2f u) {
        const Vec3f wo = cosine_hemisphere(u);
        if (wi.z <= 0 || wo.z <= 0) return std::nullopt;
        return BsdfSample{wo, reflectance, std::numbers::inv_pi_v<float> * wo.z};
    }
    /// Colours that a reflectance cannot have lose what would be negative or more than all light.
    FloatLanes spectrum(const Colour& c) const {
        const FloatLanes sum = c[0] * basis_[0] + c[1] * basis_[1] + c[2] * basis_[2];
        return min_lanes(max_lanes(sum, FloatLanes{}), splat(1.0f));
    }
    FloatLanes reflectance(const Patch& patch) const {
        const int width = pixels_->width, height = pixels_->height;
        const double x = patch.u * width - 0.5, y = (1 - patch.v) * height - 0.5;
        const double left = std::floor(x), top = std::floor(y);
        const auto a = static_cast<float>(x - left), b = static_cast<float>(y - top);
        const auto wrap = [](double at, int size) {
            const int i = static_cast<int>(at) % size;
            return i < 0 ? i + size : i;
        };
        const int columns[] = {wrap(left, width), wrap(left + 1, width)};
        const int rows[] = {wrap(top, height), wrap(top + 1, height)};
        Colour sum{};
        for (int row = 0; row < 2; ++row) {
            for (int column = 0; column < 2; ++column) {
                const float weight = (column ? a : 1 - a) * (row ? b : 1 - b);
                const float* pixel =
                    &pixels_
                         ->rgb[3 * (static_cast<std::size_t>(rows[row]) * width + columns[column])];
                for (int c = 0; c < 3; ++c) sum[c] += weight * pixel[c];
            }
        }
        return spectrum(sum);
    }

    std::shared_ptr<const DiffusePicture::Pixels> pixels_;
    std::array<FloatLanes, 3> basis_;
    FloatLanes mean_;
};

}  // namespace

DiffusePicture::DiffusePicture(Pixels pixels) {
    if (pixels.width < 1 || pixels.height < 1 ||
        pixels.rgb.size() != std::size_t{3} * pixels.width * pixels.height) {
        throw DomainError(
            fmt::format("a picture of {} x {} pixels has {} values, not three a pixel",
                        pixels.width, pixels.height, pixels.rgb.size()));
    }
    for (const float value : pixels.rgb) {
        if (!(value >= 0 && value <= 1)) {
            throw DomainError(
                fmt::format("a reflectance in the picture is {}; allowed: 0 to 1", value));
        }
    }
    pixels_ = std::make_shared<const Pixels>(std::move(pixels));
}

std::unique_ptr<const BoundBsdf> DiffusePicture::bind(const Wavelengths& wavelengths_nm) const {
    return std::make_unique<BoundDiffusePicture>(pixels_, wavelengths_nm);
}

}  // namespace nacre::bsdf
