#include "nacre/bsdf/measured_rgl.h"

#include <algorithm>
#include <cmath>

#include "nacre/bsdf/rgb_lanes.h"
#include "nacre/bsdf/rgl_map.h"
#include "nacre/bsdf/wavelength_lanes.h"
#include "nacre/core/parallel.h"

namespace nacre::bsdf {

struct MeasuredRgl::Tables {
    explicit Tables(const RglTable& table);

    RglMap map;
    SquareWarp luminance;
    int resolution;
    int channels;
    std::vector<double> wavelengths_nm;  ///< empty: RGB
    std::vector<float> values;           ///< [slice][row][column][channel]: read side by side
    SliceGrid albedo_grid;               ///< azimuths and polar angles of wi
    std::vector<float> albedo;           ///< [slice of albedo_grid][channel]

    /// Calls visit(weight, values of the channels) for the corners of an interpolation.
    template <class Visit>
    void for_each_corner(const SliceMix& mix, Vec2f sample, Visit&& visit) const {
        const SquareCell cell = locate_in_square(sample, resolution, resolution);
        const std::size_t square = static_cast<std::size_t>(resolution) * resolution;
        for (int k = 0; k < mix.count; ++k) {
            for (int corner = 0; corner < 4; ++corner) {
                const bool up = corner & 1, right = corner & 2;
                const std::size_t at = mix.slice[k] * square +
                                       static_cast<std::size_t>(cell.row + up) * resolution +
                                       cell.column + right;
                visit(mix.weight[k] * (up ? cell.row_share : 1 - cell.row_share) *
                          (right ? cell.column_share : 1 - cell.column_share),
                      values.data() + at * channels);
            }
        }
    }

 private:
    void tabulate_albedo();
};

namespace {

constexpr int kAlbedoAngles = 33, kAlbedoAzimuths = 12, kAlbedoSamples = 24;
/// Below, f is taken as at this cosine: the format stores f cos(theta_o).
constexpr float kLeastCosine = 1e-6f;

std::vector<float> even(float first, float last, int count) {
    std::vector<float> nodes(count);
    for (int i = 0; i < count; ++i) nodes[i] = first + (last - first) * i / (count - 1);
    return nodes;
}

SliceGrid make_albedo_grid(const RglTable& table) {
    constexpr float kPi = std::numbers::pi_v<float>;
    return {table.isotropic() ? std::vector<float>{0.0f} : even(-kPi, kPi, kAlbedoAzimuths + 1),
            even(0, 0.5f * kPi * 0.9999f, kAlbedoAngles)};
}

// The model at eight wavelengths.
class BoundMeasuredRgl final : public BoundBsdf {
 public:
    BoundMeasuredRgl(std::shared_ptr<const MeasuredRgl::Tables> tables,
                     const Wavelengths& wavelengths)
        : tables_(std::move(tables)), spectrum_(wavelengths) {
        if (!is_rgb()) where_ = locate_wavelengths(tables_->wavelengths_nm, wavelengths);
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

    BsdfValue evaluate(Vec3f wi, Vec3f wo) const override {
        if (wi.z <= 0 || wo.z <= 0) return {};
        const RglIncident i = tables_->map.incident(wi);
        const RglPoint point = tables_->map.towards(i, turned(i, wo));
        return {value(i, point, wo.z), density(i, point)};
    }

    std::optional<BsdfSample> sample(Vec3f wi, float /*u_lobe*/, Vec2f u) const override {
        if (wi.z <= 0) return std::nullopt;
        const RglIncident i = tables_->map.incident(wi);
        const RglPoint point = tables_->map.at(i, tables_->luminance.sample(i.mix, u).at);
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
        const float factor = tables_->map.scale(i, point) / std::max(cosine, kLeastCosine);
        if (is_rgb()) {
            std::array<float, 3> rgb{};
            tables_->for_each_corner(i.mix, point.sample, [&](float weight, const float* at) {
                for (int c = 0; c < 3; ++c) rgb[c] += weight * at[c];
            });
            return factor * spectrum_(rgb);
        }
        FloatLanes sum{};
        tables_->for_each_corner(i.mix, point.sample,
                                 [&](float weight, const float* at) { sum += weight * lanes(at); });
        return factor * max_lanes(sum, FloatLanes{});
    }

    float density(const RglIncident& i, const RglPoint& point) const {
        return tables_->luminance.density(i.mix, point.sample) *
               tables_->map.solid_angle_density(i, point);
    }

    std::shared_ptr<const MeasuredRgl::Tables> tables_;
    RgbLanes spectrum_;
    std::array<Between, kLanes> where_;
};

}  // namespace

MeasuredRgl::Tables::Tables(const RglTable& table)
    : map(table),
      luminance(table.luminance, static_cast<int>(table.slices()), table.resolution,
                table.resolution),
      resolution(table.resolution),
      channels(static_cast<int>(table.channels())),
      wavelengths_nm(table.wavelengths.begin(), table.wavelengths.end()),
      values(table.spectra.size()),
      albedo_grid(make_albedo_grid(table)) {
    const std::size_t square = static_cast<std::size_t>(resolution) * resolution;
    for (std::size_t slice = 0; slice < table.slices(); ++slice) {
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
            for_each_corner(i.mix, u, [&](float weight, const float* at) {
                for (int c = 0; c < channels; ++c) sum[c] += weight * factor * at[c];
            });
        }
        for (int c = 0; c < channels; ++c) {
            albedo[slice * channels + c] = static_cast<float>(std::max(0.0, sum[c] / kPoints));
        }
    });
}

MeasuredRgl::MeasuredRgl(const RglTable& table) : tables_(std::make_shared<const Tables>(table)) {}

MeasuredRgl::~MeasuredRgl() = default;

std::unique_ptr<const BoundBsdf> MeasuredRgl::bind(const Wavelengths& wavelengths_nm) const {
    return std::make_unique<const BoundMeasuredRgl>(tables_, wavelengths_nm);
}

}  // namespace nacre::bsdf
