#include "nacre/render/environment.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/render/film_range.h"
#include "nacre/render/sky.h"

namespace nacre::render {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

class ConstantRadiance final : public EnvironmentRadiance {
 public:
    ConstantRadiance(int spectrum, double scale)
        : spectrum_(spectrum), scale_(static_cast<float>(scale)) {}

    FloatLanes radiance(Vec3f, const FloatLanes* basis) const override {
        return scale_ * basis[spectrum_];
    }
    float luminance(Vec3f) const override { return scale_; }

 private:
    int spectrum_;
    float scale_;
};

/// Luminance of soft boxes over a vertical gradient; all of one spectrum.
class StudioRadiance final : public EnvironmentRadiance {
 public:
    StudioRadiance(const StudioEnvironment& studio, int spectrum) : spectrum_(spectrum) {
        const double scale = studio.radiance.scale;
        horizon_ = static_cast<float>(scale * studio.horizon);
        zenith_ = static_cast<float>(scale * studio.zenith);
        for (const SoftBox& box : studio.boxes.empty() ? studio_soft_boxes() : studio.boxes) {
            Box b;
            b.normal = direction_from_angles(box.azimuth_deg, box.elevation_deg);
            b.right = direction_from_angles(box.azimuth_deg + 90, 0);
            b.up = cross(b.normal, b.right);
            b.per_half_width = static_cast<float>(1 / std::tan(0.5 * box.width_deg * kDegree));
            b.per_half_height = static_cast<float>(1 / std::tan(0.5 * box.height_deg * kDegree));
            // A hard edge is a fade over a width far below any pixel.
            b.per_fade = static_cast<float>(1 / std::max(box.softness, 1e-6));
            b.luminance = static_cast<float>(scale * box.scale);
            boxes_.push_back(b);
        }
    }

    FloatLanes radiance(Vec3f direction, const FloatLanes* basis) const override {
        return luminance(direction) * basis[spectrum_];
    }
    float luminance(Vec3f direction) const override {
        float sum = horizon_ + (zenith_ - horizon_) * smooth_step(direction.z);
        for (const Box& box : boxes_) {
            const float depth = dot(direction, box.normal);
            if (depth <= 0) continue;
            const float x = std::abs(dot(direction, box.right)) * box.per_half_width;
            const float y = std::abs(dot(direction, box.up)) * box.per_half_height;
            if (x >= depth || y >= depth) continue;
            const float inverse = box.per_fade / depth;
            sum += box.luminance * smooth_step((depth - x) * inverse) *
                   smooth_step((depth - y) * inverse);
        }
        return sum;
    }

 private:
    struct Box {
        Vec3f normal, right, up;
        float per_half_width, per_half_height, per_fade, luminance;
    };

    /// Rises from 0 at x <= 0 to 1 at x >= 1 with level ends.
    static float smooth_step(float x) {
        x = std::clamp(x, 0.0f, 1.0f);
        return x * x * (3 - 2 * x);
    }

    int spectrum_;
    float horizon_, zenith_;
    std::vector<Box> boxes_;
};

/// A latitude-longitude picture, bilinear between the centres of its pixels.
class ImageRadiance final : public EnvironmentRadiance {
 public:
    ImageRadiance(const ImageEnvironment& image, int first_spectrum)
        : image_(image), first_(first_spectrum) {
        for (float& value : image_.rgb) value *= static_cast<float>(image.scale);
    }

    FloatLanes radiance(Vec3f direction, const FloatLanes* basis) const override {
        const Vec3f c = look_up(direction);
        return c.x * basis[first_] + c.y * basis[first_ + 1] + c.z * basis[first_ + 2];
    }
    float luminance(Vec3f direction) const override {
        const Vec3f c = look_up(direction);
        return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z;  // Y of linear Rec. 709
    }

 private:
    Vec3f texel(int column, int row) const {
        const std::size_t i = 3 * (static_cast<std::size_t>(row) * image_.width + column);
        return {image_.rgb[i], image_.rgb[i + 1], image_.rgb[i + 2]};
    }
    Vec3f look_up(Vec3f direction) const {
        constexpr float kTurn = 2 * std::numbers::pi_v<float>;
        const float azimuth = std::atan2(direction.y, direction.x);
        const float zenith = std::acos(std::clamp(direction.z, -1.0f, 1.0f));
        // Columns run against the azimuth, so that the picture is not mirrored seen from inside.
        float u = (static_cast<float>(image_.azimuth_deg * kDegree) - azimuth) / kTurn + 0.5f;
        u -= std::floor(u);
        const float x = u * image_.width - 0.5f;
        const float y = std::clamp(2 * zenith / kTurn * image_.height - 0.5f, 0.0f,
                                   static_cast<float>(image_.height - 1));
        const float x_floor = std::floor(x);
        const float fx = x - x_floor;
        const int column = (static_cast<int>(x_floor) + image_.width) % image_.width;
        const int next_column = (column + 1) % image_.width;
        const int row = static_cast<int>(y);
        const int next_row = std::min(row + 1, image_.height - 1);
        const float fy = y - static_cast<float>(row);
        return (1 - fy) * ((1 - fx) * texel(column, row) + fx * texel(next_column, row)) +
               fy * ((1 - fx) * texel(column, next_row) + fx * texel(next_column, next_row));
    }

    ImageEnvironment image_;
    int first_;
};

struct Compiler {
    EmissionBasis& basis;

    CompiledEnvironment operator()(const ConstantEnvironment& e) const {
        const int spectrum = basis.add(unit_illuminant(e.radiance.illuminant));
        return {std::make_unique<ConstantRadiance>(spectrum, e.radiance.scale), {}, 1, 1};
    }
    CompiledEnvironment operator()(const StudioEnvironment& e) const {
        const int spectrum = basis.add(unit_illuminant(e.radiance.illuminant));
        return {std::make_unique<StudioRadiance>(e, spectrum), {}, 256, 128};
    }
    CompiledEnvironment operator()(const SkyEnvironment& e) const { return compile_sky(e, basis); }
    CompiledEnvironment operator()(const ImageEnvironment& e) const {
        const auto primaries = rec709_light_basis();
        const int first = basis.add(primaries[0]);
        basis.add(primaries[1]);
        basis.add(primaries[2]);
        // As fine as the picture, so that a sun of one pixel is found, within reason.
        return {std::make_unique<ImageRadiance>(e, first),
                {},
                std::clamp(e.width, 16, 2048),
                std::clamp(e.height, 16, 1024)};
    }
};

}  // namespace

Vec3f direction_from_angles(double azimuth_deg, double elevation_deg) {
    const double azimuth = azimuth_deg * kDegree;
    const double elevation = elevation_deg * kDegree;
    return {static_cast<float>(std::cos(elevation) * std::cos(azimuth)),
            static_cast<float>(std::cos(elevation) * std::sin(azimuth)),
            static_cast<float>(std::sin(elevation))};
}

CompiledEnvironment compile_environment(const Environment& description, EmissionBasis& basis) {
    return std::visit(Compiler{basis}, description);
}

std::vector<SoftBox> studio_soft_boxes() {
    return {
        {.azimuth_deg = -138,
         .elevation_deg = 42,
         .width_deg = 52,
         .height_deg = 52,
         .softness = 0.18,
         .scale = 4.5},
        {.azimuth_deg = -28,
         .elevation_deg = 18,
         .width_deg = 18,
         .height_deg = 84,
         .softness = 0.25,
         .scale = 3.5},
        {.azimuth_deg = 90,
         .elevation_deg = 78,
         .width_deg = 90,
         .height_deg = 50,
         .softness = 0.3,
         .scale = 2.6},
        {.azimuth_deg = 140,
         .elevation_deg = 10,
         .width_deg = 30,
         .height_deg = 70,
         .softness = 0.4,
         .scale = 2},
    };
}

}  // namespace nacre::render
