#include "nacre/bsdf/measured/rgl.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "nacre/bsdf/wavelength_lanes.h"
#include "nacre/core/error.h"
#include "nacre/core/lane_math.h"
#include "nacre/core/math.h"
#include "nacre/core/parallel.h"

namespace nacre::bsdf {

namespace {

void require_size(const char* field, std::size_t found, std::size_t wanted) {
    if (found != wanted) {
        throw DomainError(fmt::format("{} has {} values, not {}", field, found, wanted));
    }
}

void require_values(const char* field, const std::vector<float>& values, const Range& range) {
    const auto wrong =
        std::find_if(values.begin(), values.end(), [&](float v) { return !range.contains(v); });
    if (wrong != values.end()) {
        throw DomainError(fmt::format("{}[{}] = {}: must be a number in {}", field,
                                      wrong - values.begin(), *wrong, range.text()));
    }
}

void require_increasing(const char* field, const std::vector<float>& values, const Range& range) {
    if (values.empty()) throw DomainError(fmt::format("{} is empty", field));
    require_values(field, values, range);
    const auto wrong = std::adjacent_find(values.begin(), values.end(), std::greater_equal<>());
    if (wrong != values.end()) {
        throw DomainError(fmt::format("{}[{}] = {} follows {}: the values must increase", field,
                                      wrong - values.begin() + 1, *(wrong + 1), *wrong));
    }
}

void require_sides(const char* field, int rows, int columns) {
    if (rows < 2 || columns < 2) {
        throw DomainError(
            fmt::format("{} has {} x {} values: must have 2 x 2 or more", field, rows, columns));
    }
}

std::size_t cells(int rows, int columns) { return static_cast<std::size_t>(rows) * columns; }

void validate_square(const char* field, const SquareTable& table, const Range& range) {
    require_sides(field, table.rows, table.columns);
    require_size(field, table.values.size(), cells(table.rows, table.columns));
    require_values(field, table.values, range);
}

}  // namespace

void validate(const RglTable& table) {
    // Products of these, over the least cosine, are still finite in single precision.
    constexpr float kMax = 1e9f;
    constexpr Range kDensity{0, kMax}, kAny{-kMax, kMax};
    // Files hold 90 and 180 deg as rounded floats.
    constexpr Range kTheta{0, 0.5 * kPiF * 1.00001, "rad"},
        kPhi{-kPiF * 2.00001, kPiF * 2.00001, "rad"};
    constexpr float kMaxOff = 0.2f;  // rad: a first azimuth half a step inside
    require_increasing("phi_i", table.phi_i, kPhi);
    require_increasing("theta_i", table.theta_i, kTheta);
    if (!table.isotropic()) {
        const float parts = 2 * kPiF / (table.phi_i.back() - table.phi_i.front());
        const float whole = std::round(parts);
        if (whole != 1 && whole != 2 && whole != 4) {
            throw DomainError(
                fmt::format("phi_i spans {} rad: an anisotropic surface must have pi/2, pi or 2 pi",
                            table.phi_i.back() - table.phi_i.front()));
        }
        // Incident directions are turned there; a table of others would be read at its edges.
        if (std::abs(table.phi_i.front() + kPiF) > kMaxOff) {
            throw DomainError(fmt::format(
                "phi_i begins at {} rad: those of an anisotropic surface must begin at -pi",
                table.phi_i.front()));
        }
    }
    validate_square("ndf", table.ndf, kDensity);
    validate_square("sigma", table.sigma, Range{1e-9, kMax});
    require_sides("vndf", table.vndf_rows, table.vndf_columns);
    require_size("vndf", table.vndf.size(),
                 table.slices() * cells(table.vndf_rows, table.vndf_columns));
    require_values("vndf", table.vndf, kDensity);
    require_sides("luminance", table.resolution, table.resolution);
    const std::size_t square = cells(table.resolution, table.resolution);
    require_size("luminance", table.luminance.size(), table.slices() * square);
    require_values("luminance", table.luminance, kDensity);
    if (!table.is_rgb()) {
        if (table.wavelengths.size() > kMaxRglWavelengths) {
            throw DomainError(fmt::format("wavelengths has {} values: must have at most {}",
                                          table.wavelengths.size(), kMaxRglWavelengths));
        }
        require_increasing("wavelengths", table.wavelengths, Range{1, 1e6, "nm"});
    }
    const char* values = table.is_rgb() ? "rgb" : "spectra";
    require_size(values, table.spectra.size(), table.slices() * table.channels() * square);
    require_values(values, table.spectra, kAny);
}

namespace {

const RglTable& checked(const RglTable& table) {
    validate(table);
    return table;
}

int parts_of_circle(const RglTable& table) {
    if (table.isotropic()) return 1;
    return static_cast<int>(std::round(2 * kPiF / (table.phi_i.back() - table.phi_i.front())));
}

}  // namespace

float read_square(const SquareTable& table, Vec2f point) {
    const SquareCell<float> cell = locate_in_square(point, table.rows, table.columns);
    const float* at =
        table.values.data() + static_cast<std::size_t>(cell.row) * table.columns + cell.column;
    const float low = at[0] + cell.column_fraction * (at[1] - at[0]);
    at += table.columns;
    const float high = at[0] + cell.column_fraction * (at[1] - at[0]);
    return low + cell.row_fraction * (high - low);
}

RglMap::RglMap(const RglTable& table, SharedProgress* work)
    : isotropic_(checked(table).isotropic()),
      jacobian_(table.jacobian),
      parts_(parts_of_circle(table)),
      grid_(table.phi_i, table.theta_i),
      ndf_(table.ndf),
      sigma_(table.sigma),
      vndf_(table.vndf, static_cast<int>(table.slices()), table.vndf_rows, table.vndf_columns,
            work) {}

namespace {

/// sin and cos of half the angle from the normal. As in polar_angle(), by the chord: the normal itself
/// is a pole, where rounding decides.
template <class T>
CosineSine<T> half_polar_angle(const Vec3<T>& w) {
    const T sine = 0.5f * sqrt_lanes(w.x * w.x + w.y * w.y + (w.z - 1) * (w.z - 1));
    return {sqrt_lanes(max_lanes(1 - sine * sine, T{})), sine};
}

struct Angles {
    float polar, azimuth;
};
/// Both at once, of a unit vector.
Angles angles_of(Vec3f w) {
    const CosineSine<float> half = half_polar_angle(w);
    const FloatLanes angle = atan2_lanes(FloatLanes{half.sine, w.y}, FloatLanes{half.cosine, w.x});
    return {2 * angle[0], angle[1]};
}

}  // namespace

// Half the circle was measured where the surface looks the same after half a turn, from -180 to
// 0 deg; a quarter where it has two mirror planes, from -180 to -90 deg.
RglIncident RglMap::incident(Vec3f wi) const {
    RglIncident i;
    i.flip_x = i.flip_y = 1;
    if (parts_ >= 2) {
        i.flip_y = -std::copysign(1.0f, wi.y);
        i.flip_x = parts_ == 4 ? -std::copysign(1.0f, wi.x) : i.flip_y;
    }
    i.direction = {i.flip_x * wi.x, i.flip_y * wi.y, wi.z};
    const auto [theta, phi] = angles_of(i.direction);
    i.phi = phi;
    i.mix = grid_.locate(i.phi, theta);
    i.inverse_sigma = 1 / read_square(sigma_, square_point(theta, i.phi));
    return i;
}

RglPoint RglMap::towards(const RglIncident& i, Vec3f wo) const {
    RglPoint point;
    point.normal = normalize(i.direction + wo);
    const auto [polar, azimuth] = angles_of(point.normal);
    point.half = square_point(polar, isotropic_ ? azimuth - i.phi : azimuth);
    const SquareWarp::Point found = vndf_.invert(i.mix, point.half);
    point.sample = found.at;
    point.density = found.density;
    return point;
}

RglPointOf<FloatLanes> RglMap::towards(const RglIncident& i, const Vec3Lanes& wo) const {
    const Vec3Lanes sum = splat(i.direction) + wo;
    const FloatLanes inverse = 1 / sqrt_lanes(dot(sum, sum));
    RglPointOf<FloatLanes> point;
    point.normal = inverse * sum;
    const CosineSine<FloatLanes> half = half_polar_angle(point.normal);
    const FloatLanes polar = 2 * atan2_lanes(half.sine, half.cosine);
    const FloatLanes azimuth =
        atan2_lanes(point.normal.y, point.normal.x) - (isotropic_ ? i.phi : 0.0f);
    const FloatLanes turns = (azimuth + kPiF) * (0.5f / kPiF);
    // Above -1 and below 2.
    const FloatLanes below_one = turns < 1 ? turns : turns - 1;
    point.half = {sqrt_lanes(polar * (2 / kPiF)), turns < 0 ? turns + 1 : below_one};
    const SquareWarp::Inverse<FloatLanes> found = vndf_.invert_at(i.mix, point.half);
    point.sample = found.at;
    point.density = found.density;
    return point;
}

RglPoint RglMap::at(const RglIncident& i, Vec2f sample) const {
    const SquareWarp::Point found = vndf_.sample(i.mix, sample);
    RglPoint point;
    point.sample = sample;
    point.half = found.at;
    point.density = found.density;
    const float azimuth = found.at.y - 0.5f + (isotropic_ ? i.phi * (0.5f / kPiF) : 0.0f);
    const auto [cosine, sine] = cos_sin_turns(FloatLanes{0.25f * found.at.x * found.at.x, azimuth});
    point.normal = {sine[0] * cosine[1], sine[0] * sine[1], cosine[0]};
    return point;
}

float RglMap::scale(const RglIncident& i, const RglPoint& point) const {
    return jacobian_ ? 0.25f * read_square(ndf_, point.half) * i.inverse_sigma : 1.0f;
}

// Steps of the half vector in the square are 2 pi^2 x dx dy of its angles, those of wo 4 w_i.m of
// its solid angle. At the normal itself, where x and the sine vanish and the interpolated density
// need not, the density has a pole that still can be integrated.
template <class T>
T RglMap::solid_angle_density(const RglIncident& i, const RglPointOf<T>& point) const {
    constexpr float kMin = 1e-12f;
    const auto& [x, y, z] = point.normal;
    const T area = 2 * kPiF * kPiF * point.half.x * sqrt_lanes(x * x + y * y);
    const T cosine = x * i.direction.x + y * i.direction.y + z * i.direction.z;
    return point.density / max_lanes(area * 4 * cosine, T{} + kMin);
}
template float RglMap::solid_angle_density(const RglIncident&, const RglPoint&) const;
template FloatLanes RglMap::solid_angle_density(const RglIncident&,
                                                const RglPointOf<FloatLanes>&) const;

struct MeasuredRgl::Tables {
    Tables(const RglTable& table, SharedProgress* work);

    RglMap map;
    SquareWarp luminance;
    int resolution;
    int channels;
    std::vector<double> wavelengths_nm;  ///< empty: RGB
    std::vector<float> values;           ///< [slice][row][column][channel]: read side by side
    SliceGrid albedo_grid;               ///< azimuths and polar angles of wi
    std::vector<float> albedo;           ///< [slice of albedo_grid][channel]

    /// Calls visit(weight, cell) for the corners of an interpolation, whose channels begin at
    /// values[cell * channels].
    template <class Visit>
    void for_each_corner(const SliceMix& mix, Vec2f sample, Visit&& visit) const {
        const SquareCell<float> cell = locate_in_square(sample, resolution, resolution);
        const std::size_t square = static_cast<std::size_t>(resolution) * resolution;
        for (int k = 0; k < mix.count; ++k) {
            for (int corner = 0; corner < 4; ++corner) {
                const bool up = corner & 1, right = corner & 2;
                const std::size_t at = mix.slice[k] * square +
                                       static_cast<std::size_t>(cell.row + up) * resolution +
                                       cell.column + right;
                visit(mix.weight[k] * (up ? cell.row_fraction : 1 - cell.row_fraction) *
                          (right ? cell.column_fraction : 1 - cell.column_fraction),
                      at);
            }
        }
    }

 private:
    void tabulate_albedo();
};

namespace {

constexpr int kAlbedoAngles = 33, kAlbedoAzimuths = 12, kAlbedoSamples = 24;
/// Below, f is taken as at this cosine: the format stores f cos(theta_o).
constexpr float kMinCosine = 1e-6f;

std::vector<float> even(float first, float last, int count) {
    std::vector<float> nodes(count);
    for (int i = 0; i < count; ++i) nodes[i] = first + (last - first) * i / (count - 1);
    return nodes;
}

SliceGrid make_albedo_grid(const RglTable& table) {
    return {table.isotropic() ? std::vector<float>{0.0f} : even(-kPiF, kPiF, kAlbedoAzimuths + 1),
            even(0, 0.5f * kPiF * 0.9999f, kAlbedoAngles)};
}

// The model at eight wavelengths.
class BoundMeasuredRgl final : public BoundBsdf {
 public:
    BoundMeasuredRgl(std::shared_ptr<const MeasuredRgl::Tables> tables,
                     const Wavelengths& wavelengths)
        : tables_(std::move(tables)), spectrum_(wavelengths) {
        if (is_rgb()) return;
        where_ = locate_wavelengths(tables_->wavelengths_nm, wavelengths);
        // What is read for each direction lies side by side, in fewer lines of the cache.
        const std::size_t cells = tables_->values.size() / tables_->channels;
        values_.resize(cells);
        for (std::size_t cell = 0; cell < cells; ++cell) {
            values_[cell] = lanes(tables_->values.data() + cell * tables_->channels);
        }
    }

    FloatLanes eval(Vec3f wi, Vec3f wo) const override {
        if (wi.z <= 0 || wo.z <= 0) return FloatLanes{};
        const RglIncident i = tables_->map.incident(wi);
        return value(i, tables_->map.towards(i, turned(i, wo)), wo.z);
    }

    float pdf(Vec3f wi, Vec3f wo) const override {
        if (wi.z <= 0 || wo.z <= 0) return 0;
        const RglIncident i = tables_->map.incident(wi);
        return density(i, tables_->map.towards(i, turned(i, wo)));
    }
    FloatLanes pdf_lanes(Vec3f wi, const Vec3Lanes& wo) const override {
        if (wi.z <= 0) return FloatLanes{};
        const RglIncident i = tables_->map.incident(wi);
        const Vec3Lanes there = {i.flip_x * wo.x, i.flip_y * wo.y, wo.z};
        return wo.z > 0 ? density(i, tables_->map.towards(i, there)) : FloatLanes{};
    }

    BsdfValue evaluate(Vec3f wi, Vec3f wo) const override {
        if (wi.z <= 0 || wo.z <= 0) return {};
        const RglIncident i = tables_->map.incident(wi);
        const RglPoint point = tables_->map.towards(i, turned(i, wo));
        return {value(i, point, wo.z), density(i, point)};
    }

    std::optional<BsdfSample> sample(Vec3f wi, float /*u_select*/, Vec2f u) const override {
        if (wi.z <= 0) return std::nullopt;
        const RglIncident i = tables_->map.incident(wi);
        const Vec2f at = tables_->luminance.sample(i.mix, u).at;
        // The values come while the half vector is found.
        if (!is_rgb()) {
            tables_->for_each_corner(
                i.mix, at, [&](float, std::size_t cell) { __builtin_prefetch(&values_[cell]); });
        }
        const RglPoint point = tables_->map.at(i, at);
        const float cosine = dot(i.direction, point.normal);
        const Vec3f wo = 2 * cosine * point.normal - i.direction;
        if (cosine <= 0 || wo.z <= 0) return std::nullopt;
        BsdfSample s;
        s.wo = turned(i, wo);
        s.pdf = density(i, point);
        if (!(s.pdf > 0)) return std::nullopt;
        s.weight = value(i, point, wo.z) * (wo.z / s.pdf);
        return s;
    }

    FloatLanes albedo(Vec3f wi) const override {
        if (wi.z <= 0) return FloatLanes{};
        const SliceMix mix = tables_->albedo_grid.locate(std::atan2(wi.y, wi.x), polar_angle(wi));
        FloatLanes sum{};
        for (int k = 0; k < mix.count; ++k) {
            sum +=
                mix.weight[k] * lanes(tables_->albedo.data() +
                                      static_cast<std::size_t>(mix.slice[k]) * tables_->channels);
        }
        return sum;
    }

 private:
    bool is_rgb() const { return tables_->wavelengths_nm.empty(); }
    static Vec3f turned(const RglIncident& i, Vec3f w) {
        return {i.flip_x * w.x, i.flip_y * w.y, w.z};
    }
    FloatLanes lanes(const float* channels) const {
        if (is_rgb()) return spectrum_({channels[0], channels[1], channels[2]});
        return at_wavelengths(where_, [&](int i) { return channels[i]; });
    }

    FloatLanes value(const RglIncident& i, const RglPoint& point, float cosine) const {
        const float factor = tables_->map.scale(i, point) / std::max(cosine, kMinCosine);
        if (is_rgb()) {
            spectra::Rgb rgb;
            tables_->for_each_corner(i.mix, point.sample, [&](float weight, std::size_t cell) {
                const float* const at = tables_->values.data() + 3 * cell;
                for (int c = 0; c < 3; ++c) rgb[c] += weight * at[c];
            });
            return factor * spectrum_(rgb);
        }
        FloatLanes sum{};
        tables_->for_each_corner(i.mix, point.sample, [&](float weight, std::size_t cell) {
            sum += weight * values_[cell];
        });
        return factor * max_lanes(sum, FloatLanes{});
    }

    template <class T>
    T density(const RglIncident& i, const RglPointOf<T>& point) const {
        return tables_->luminance.density(i.mix, point.sample) *
               tables_->map.solid_angle_density(i, point);
    }

    std::shared_ptr<const MeasuredRgl::Tables> tables_;
    RgbLanes spectrum_;
    std::array<WavelengthPosition, kLanes> where_;
    std::vector<FloatLanes> values_;  ///< of spectra, by cell
};

}  // namespace

MeasuredRgl::Tables::Tables(const RglTable& table, SharedProgress* work)
    : map(table, work),
      luminance(table.luminance, static_cast<int>(table.slices()), table.resolution,
                table.resolution, work),
      resolution(table.resolution),
      channels(static_cast<int>(table.channels())),
      wavelengths_nm(table.wavelengths.begin(), table.wavelengths.end()),
      albedo_grid(make_albedo_grid(table)) {
    const std::size_t square = static_cast<std::size_t>(resolution) * resolution;
    values.reserve(table.spectra.size());
    for (std::size_t slice = 0; slice < table.slices(); ++slice) {
        if (work) work->throw_if_stopped("preparing a measured BRDF");
        values.resize((slice + 1) * square * channels);
        for (int c = 0; c < channels; ++c) {
            const float* from = table.spectra.data() + (slice * channels + c) * square;
            float* to = values.data() + slice * square * channels + c;
            for (std::size_t i = 0; i < square; ++i) to[i * channels] = from[i];
        }
    }
    tabulate_albedo();
}

// The mean of weights over points of the square, which lie where light goes.
void MeasuredRgl::Tables::tabulate_albedo() {
    const std::size_t polar = albedo_grid.second().size();
    albedo.assign(albedo_grid.first().size() * polar * channels, 0.0f);
    parallel_for(0, albedo_grid.first().size() * polar, [&](std::size_t slice) {
        const float phi = albedo_grid.first()[slice / polar];
        const float theta = albedo_grid.second()[slice % polar];
        const RglIncident i = map.incident(
            {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)});
        std::vector<double> sum(channels, 0.0);
        constexpr int kPoints = kAlbedoSamples * kAlbedoSamples;
        for (int k = 0; k < kPoints; ++k) {
            const Vec2f u = {(k % kAlbedoSamples + 0.5f) / kAlbedoSamples,
                             (k / kAlbedoSamples + 0.5f) / kAlbedoSamples};
            const RglPoint point = map.at(i, u);
            const float cosine = dot(i.direction, point.normal);
            const float density = map.solid_angle_density(i, point);
            if (cosine <= 0 || 2 * cosine * point.normal.z <= i.direction.z || !(density > 0)) {
                continue;
            }
            const float factor = map.scale(i, point) / density;
            for_each_corner(i.mix, u, [&](float weight, std::size_t cell) {
                const float* const at = values.data() + cell * channels;
                for (int c = 0; c < channels; ++c) sum[c] += weight * factor * at[c];
            });
        }
        for (int c = 0; c < channels; ++c) {
            albedo[slice * channels + c] = static_cast<float>(std::max(0.0, sum[c] / kPoints));
        }
    });
}

MeasuredRgl::MeasuredRgl(const RglTable& table, SharedProgress* work)
    : tables_(std::make_shared<const Tables>(table, work)) {}

MeasuredRgl::~MeasuredRgl() = default;

std::unique_ptr<const BoundBsdf> MeasuredRgl::bind(const Wavelengths& wavelengths_nm) const {
    return std::make_unique<const BoundMeasuredRgl>(tables_, wavelengths_nm);
}

}  // namespace nacre::bsdf
