#include "nacre/render/environment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "nacre/core/math.h"
#include "nacre/render/emission.h"
#include "nacre/spectra/rgb.h"

namespace nacre::render {
namespace {

class ConstantRadiance final : public EnvironmentRadiance {
 public:
    ConstantRadiance(int spectrum, double scale)
        : spectrum_(spectrum), scale_(static_cast<float>(scale)) {}

    Coefficients coefficients(Vec3f) const override { return {scale_}; }
    float luminance_of(const Coefficients& c) const override { return c[0]; }
    Coefficients white() const override { return {1}; }
    FloatLanes combined(const Coefficients& c, const FloatLanes* basis) const override {
        return c[0] * basis[spectrum_];
    }

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

    float luminance_of(const Coefficients& c) const override { return c[0]; }
    Coefficients white() const override { return {1}; }
    FloatLanes combined(const Coefficients& c, const FloatLanes* basis) const override {
        return c[0] * basis[spectrum_];
    }
    Coefficients coefficients(Vec3f direction) const override {
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
        return {sum};
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

    Coefficients coefficients(Vec3f direction) const override {
        const Vec3f c = look_up(direction);
        return {c.x, c.y, c.z};
    }
    FloatLanes combined(const Coefficients& c, const FloatLanes* basis) const override {
        return c[0] * basis[first_] + c[1] * basis[first_ + 1] + c[2] * basis[first_ + 2];
    }
    float luminance_of(const Coefficients& c) const override {
        return spectra::rec709_luminance(c[0], c[1], c[2]);
    }
    Coefficients white() const override { return {1, 1, 1}; }

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

/// Points around the horizon of which so many lie across the smallest box.
double points_around(const StudioEnvironment& studio, int across_smallest) {
    double smallest_deg = 90;
    for (const SoftBox& box : studio.boxes.empty() ? studio_soft_boxes() : studio.boxes) {
        smallest_deg = std::min({smallest_deg, box.width_deg, box.height_deg});
    }
    return across_smallest * 360 / smallest_deg;
}

struct Compiler {
    EmissionBasis& basis;

    CompiledEnvironment operator()(const ConstantEnvironment& e) const {
        const int spectrum = basis.add(unit_illuminant(e.radiance.illuminant));
        return {std::make_unique<ConstantRadiance>(spectrum, e.radiance.scale), {}, 1, 1};
    }
    CompiledEnvironment operator()(const StudioEnvironment& e) const {
        const int spectrum = basis.add(unit_illuminant(e.radiance.illuminant));
        const auto rows = static_cast<int>(std::clamp(points_around(e, 2), 128.0, 1024.0));
        return {std::make_unique<StudioRadiance>(e, spectrum),
                {},
                2 * rows,
                rows,
                static_cast<int>(std::clamp(points_around(e, 16), 64.0, 4096.0))};
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
                std::clamp(e.height, 16, 1024),
                2 * std::clamp(std::max(e.width, 2 * e.height), 16, 2048),
                e.width,
                e.height};
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

namespace {

/// One unit of luminance in the picture, in kcd/m^2.
constexpr double kUnitKcd = 10;
constexpr double kGroundReflectance = 0.2;

/// The five parameters of Perez's all-weather luminance distribution.
struct Perez {
    double a, b, c, d, e;

    double operator()(double cos_zenith, double sun_angle, double cos_sun_angle) const {
        return (1 + a * std::exp(b / cos_zenith)) *
               (1 + c * std::exp(d * sun_angle) + e * cos_sun_angle * cos_sun_angle);
    }
};

double cubic(const std::array<double, 4>& k, double x) {
    return ((k[0] * x + k[1]) * x + k[2]) * x + k[3];
}

/// Luminance and chromaticity of the sky dome as functions of direction.
class PreethamSky {
 public:
    PreethamSky(double turbidity, Vec3f sun) : sun_(sun) {
        const double t = turbidity;
        perez_luminance_ = {0.1787 * t - 1.4630, -0.3554 * t + 0.4275, -0.0227 * t + 5.3251,
                            0.1206 * t - 2.5771, -0.0670 * t + 0.3703};
        perez_x_ = {-0.0193 * t - 0.2592, -0.0665 * t + 0.0008, -0.0004 * t + 0.2125,
                    -0.0641 * t - 0.8989, -0.0033 * t + 0.0452};
        perez_y_ = {-0.0167 * t - 0.2608, -0.0950 * t + 0.0092, -0.0079 * t + 0.2102,
                    -0.0441 * t - 1.6537, -0.0109 * t + 0.0529};
        const double theta = std::acos(std::clamp<double>(sun.z, -1, 1));
        const double chi = (4.0 / 9 - t / 120) * (std::numbers::pi - 2 * theta);
        zenith_luminance_kcd_ = (4.0453 * t - 4.9710) * std::tan(chi) - 0.2155 * t + 2.4192;
        zenith_x_ = t * t * cubic({0.00166, -0.00375, 0.00209, 0}, theta) +
                    t * cubic({-0.02903, 0.06377, -0.03202, 0.00394}, theta) +
                    cubic({0.11693, -0.21196, 0.06052, 0.25886}, theta);
        zenith_y_ = t * t * cubic({0.00275, -0.00610, 0.00317, 0}, theta) +
                    t * cubic({-0.04214, 0.08970, -0.04153, 0.00516}, theta) +
                    cubic({0.15346, -0.26756, 0.06670, 0.26688}, theta);
        norm_luminance_ = perez_luminance_(1, theta, sun.z);
        norm_x_ = perez_x_(1, theta, sun.z);
        norm_y_ = perez_y_(1, theta, sun.z);
    }

    struct Colour {
        double luminance_kcd, x, y;
    };
    Colour operator()(Vec3f direction) const {
        // The formula diverges at the horizon itself; 0.01 is half a degree above it.
        const double cos_zenith = std::max<double>(direction.z, 0.01);
        const double cos_sun = std::clamp<double>(dot(direction, sun_), -1, 1);
        const double angle = std::acos(cos_sun);
        return {std::max(0.0, zenith_luminance_kcd_ * perez_luminance_(cos_zenith, angle, cos_sun) /
                                  norm_luminance_),
                zenith_x_ * perez_x_(cos_zenith, angle, cos_sun) / norm_x_,
                zenith_y_ * perez_y_(cos_zenith, angle, cos_sun) / norm_y_};
    }

 private:
    Vec3f sun_;
    Perez perez_luminance_, perez_x_, perez_y_;
    double zenith_luminance_kcd_, zenith_x_, zenith_y_;
    double norm_luminance_, norm_x_, norm_y_;
};

/// Its coefficients are those of the daylight basis.
class SkyRadiance final : public EnvironmentRadiance {
 public:
    SkyRadiance(PreethamSky sky, double scale, int first_spectrum, std::array<double, 3> luminances)
        : sky_(sky), scale_(scale), first_(first_spectrum), luminances_(luminances) {}

    Coefficients coefficients(Vec3f direction) const override {
        return direction.z > 0 ? above(direction) : ground_;
    }
    FloatLanes combined(const Coefficients& c, const FloatLanes* basis) const override {
        const FloatLanes sum =
            c[0] * basis[first_] + c[1] * basis[first_ + 1] + c[2] * basis[first_ + 2];
        // Far outside the daylight locus the combination can dip below zero at the film's ends.
        return max_lanes(sum, FloatLanes{});
    }
    float luminance(Vec3f direction) const override {
        if (direction.z <= 0) return luminance_of(ground_);
        return static_cast<float>(scale_ * sky_(direction).luminance_kcd / kUnitKcd);
    }

    Coefficients white() const override { return {static_cast<float>(1 / luminances_[0])}; }
    void set_ground(Coefficients ground) { ground_ = ground; }

    /// Spectrum of the sky's chromaticity, scaled to its luminance.
    ///                                  [cie-15-2018, eq. 4.10-4.11; preetham-1999, appendix A.5]
    Coefficients above(Vec3f direction) const {
        const PreethamSky::Colour sky = sky_(direction);
        const double m = 0.0241 + 0.2562 * sky.x - 0.7341 * sky.y;
        const double m1 = (-1.3515 - 1.7703 * sky.x + 5.9114 * sky.y) / m;
        const double m2 = (0.0300 - 31.4424 * sky.x + 30.0717 * sky.y) / m;
        const double k = scale_ * sky.luminance_kcd / kUnitKcd /
                         (luminances_[0] + m1 * luminances_[1] + m2 * luminances_[2]);
        return {static_cast<float>(k), static_cast<float>(k * m1), static_cast<float>(k * m2)};
    }

    float luminance_of(const Coefficients& c) const override {
        return static_cast<float>(c[0] * luminances_[0] + c[1] * luminances_[1] +
                                  c[2] * luminances_[2]);
    }

 private:
    PreethamSky sky_;
    double scale_;
    int first_;
    std::array<double, 3> luminances_;
    Coefficients ground_{};
};

/// Fraction of sunlight that reaches the ground.
double sun_transmittance(double wavelength_nm, double sun_elevation_deg, double turbidity) {
    const double um = wavelength_nm / 1000;
    // Relative optical mass; elevation in degrees.
    const double mass = 1 / (std::sin(sun_elevation_deg * kDegree) +
                             0.15 * std::pow(sun_elevation_deg + 3.885, -1.253));
    const double rayleigh = std::exp(-0.008735 * mass * std::pow(um, -4.08));
    const double beta = 0.04608 * turbidity - 0.04586;  // Angstrom's turbidity coefficient
    const double aerosol = std::exp(-beta * mass * std::pow(um, -1.3));
    return rayleigh * aerosol;
}

double black_body(double wavelength_nm, double kelvin) {
    constexpr double kSecondRadiation_nm = 1.438776877e7;  // h c / k in nm K
    return std::pow(wavelength_nm, -5) / std::expm1(kSecondRadiation_nm / (wavelength_nm * kelvin));
}

DistantDisk compile_sun(const SkyEnvironment& sky, Vec3f direction, EmissionBasis& basis) {
    constexpr double kOutsideKcd = 1.88e6;
    constexpr double kSolarKelvin = 5778;
    std::vector<double> nm, outside, ground;
    for (double w = kFilmFirst_nm; w <= kFilmLast_nm; w += 10) {
        nm.push_back(w);
        outside.push_back(black_body(w, kSolarKelvin));
        ground.push_back(outside.back() *
                         sun_transmittance(w, sky.sun_elevation_deg, sky.turbidity));
    }
    const double norm = kOutsideKcd / kUnitKcd / film_luminance(spectra::Spectrum(nm, outside));
    for (double& g : ground) g *= norm;
    const spectra::Spectrum spectrum(nm, ground);
    const double half_chord = std::sin(0.5 * kSunRadius_deg * kDegree);
    return {direction, static_cast<float>(4 * half_chord * half_chord),
            static_cast<float>(sky.scale), basis.add(spectrum),
            sky.scale * film_luminance(spectrum)};
}

/// Radiance of the ground: what it reflects of the sky, with the sun's fraction in the sky's
/// colour.
EnvironmentRadiance::Coefficients ground_radiance(const SkyRadiance& sky, const DistantDisk& sun) {
    constexpr int kSteps = 32;  // in azimuth and in cos^2: each cell has the same projected angle
    std::array<double, 3> sum{};
    for (int i = 0; i < kSteps * kSteps; ++i) {
        const double sine = std::sqrt((i / kSteps + 0.5) / kSteps);
        const double azimuth = 2 * std::numbers::pi * (i % kSteps + 0.5) / kSteps;
        const auto c = sky.above({static_cast<float>(sine * std::cos(azimuth)),
                                  static_cast<float>(sine * std::sin(azimuth)),
                                  static_cast<float>(std::sqrt(1 - sine * sine))});
        for (int j = 0; j < 3; ++j) sum[j] += c[j] / (kSteps * kSteps);
    }
    EnvironmentRadiance::Coefficients mean;
    for (int j = 0; j < 3; ++j) mean[j] = static_cast<float>(kGroundReflectance * sum[j]);
    // The sky's mean is irradiance / pi already; the sun's irradiance / pi, likewise.
    const double solid_angle = std::numbers::pi * sun.chord_squared;
    const double from_sun = kGroundReflectance * sun.luminance * solid_angle *
                            std::max(0.0f, sun.direction.z) / std::numbers::pi;
    const double from_sky = sky.luminance_of(mean);
    const double gain = from_sky > 0 ? 1 + from_sun / from_sky : 0;
    for (float& m : mean) m = static_cast<float>(m * gain);
    return mean;
}

}  // namespace

CompiledEnvironment compile_sky(const SkyEnvironment& sky, EmissionBasis& basis) {
    const Vec3f sun_direction = direction_from_angles(sky.sun_azimuth_deg, sky.sun_elevation_deg);
    std::array<double, 3> luminances{};
    int first = 0;
    const auto daylight = daylight_basis();
    for (int i = 0; i < 3; ++i) {
        const int index = basis.add(daylight[i]);
        if (i == 0) first = index;
        luminances[i] = film_luminance(daylight[i]);
    }
    CompiledEnvironment compiled;
    compiled.sun = compile_sun(sky, sun_direction, basis);
    auto radiance = std::make_unique<SkyRadiance>(PreethamSky(sky.turbidity, sun_direction),
                                                  sky.scale, first, luminances);
    radiance->set_ground(ground_radiance(*radiance, *compiled.sun));
    compiled.radiance = std::move(radiance);
    compiled.table_columns = 256;
    compiled.table_rows = 128;
    return compiled;
}

}  // namespace nacre::render
