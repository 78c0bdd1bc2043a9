#include "nacre/bsdf/measured/merl.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/bsdf/flake_lobe.h"
#include "nacre/bsdf/warp.h"
#include "nacre/bsdf/wavelength_lanes.h"
#include "nacre/core/error.h"
#include "nacre/core/math.h"
#include "nacre/core/parallel.h"

namespace nacre::bsdf {

HalfDifference MerlTable::middle(int h, int d, int a) const {
    const double x = (h + 0.5) / half;
    return {0.5 * std::numbers::pi * x * x, 0.5 * std::numbers::pi * (d + 0.5) / difference,
            std::numbers::pi * (a + 0.5) / azimuths};
}

void validate(const MerlTable& table) {
    const auto side = [](const char* what, int cells) {
        if (cells < kMinMerlCells || cells > kMaxMerlCells) {
            throw DomainError(fmt::format("{} cells along {}: must be in [{}, {}]", cells, what,
                                          kMinMerlCells, kMaxMerlCells));
        }
    };
    side("theta_half", table.half);
    side("theta_difference", table.difference);
    side("phi_difference", table.azimuths);
    if (table.values.size() != 3 * table.cells()) {
        throw DomainError(fmt::format("{} values: must be three times {} x {} x {}",
                                      table.values.size(), table.half, table.difference,
                                      table.azimuths));
    }
    // Finite, and still so in single precision.
    const auto wrong = std::find_if(table.values.begin(), table.values.end(),
                                    [](double v) { return !(std::abs(v) <= 1e30); });
    if (wrong != table.values.end()) {
        throw DomainError(fmt::format("value {} is {}: must be a number in [-1e30, 1e30]",
                                      wrong - table.values.begin(), *wrong));
    }
}

HalfDifference half_difference(Vec3f wi, Vec3f wo) {
    const Vec3f h = normalize(wi + wo);
    const float sine = std::sqrt(h.x * h.x + h.y * h.y);
    const float cos_phi = sine > 0 ? h.x / sine : 1.0f, sin_phi = sine > 0 ? h.y / sine : 0.0f;
    // The frame about h whose first axis lies in the plane of h and the normal, pointing down.
    const Vec3f first = {h.z * cos_phi, h.z * sin_phi, -sine}, second = {-sin_phi, cos_phi, 0};
    const float x = dot(wi, first), y = dot(wi, second), z = dot(wi, h);
    double phi = std::atan2(y, x);
    if (phi < 0) phi += std::numbers::pi;  // reciprocity
    return {std::atan2(sine, h.z), std::atan2(std::sqrt(x * x + y * y), std::max(z, 0.0f)),
            std::min(phi, std::numbers::pi)};
}

DirectionPair directions_of(const HalfDifference& angles) {
    const double sh = std::sin(angles.theta_half), ch = std::cos(angles.theta_half);
    const double sd = std::sin(angles.theta_difference), cd = std::cos(angles.theta_difference);
    const double x = sd * std::cos(angles.phi_difference), y = sd * std::sin(angles.phi_difference);
    return {{ch * x + sh * cd, y, -sh * x + ch * cd}, {-ch * x + sh * cd, -y, sh * x + ch * cd}};
}

namespace {

using spectra::Rgb;

/// Roughness of the lobes to sample from: a polished metal to a matte plastic; a cosine lobe
/// comes last.
const std::array<FlakeLobe, 4> kLobes = {FlakeLobe(0.01f), FlakeLobe(0.04f), FlakeLobe(0.15f),
                                         FlakeLobe(0.5f)};
constexpr std::size_t kStrategies = kLobes.size() + 1;
using Probability = std::array<float, kStrategies>;
/// Incident angles at which probability and albedo are tabulated, equally spaced over 90 deg.
constexpr int kRows = 33;

struct Row {
    Probability probability{};
    Rgb albedo{};
};

/// Cells on both sides of a place, and the fraction of the second.
struct Neighbours {
    int cell[2];
    float fraction;
};
Neighbours neighbours(double cells_from_edge, int count) {
    const double at = std::clamp(cells_from_edge - 0.5, 0.0, count - 1.0);
    const int lower = std::min(static_cast<int>(at), count - 2);
    return {{lower, lower + 1}, static_cast<float>(at - lower)};
}
Neighbours periodic_neighbours(double cells_from_edge, int count) {
    const double at = cells_from_edge - 0.5;
    const double floor = std::floor(at);
    const int lower = (static_cast<int>(floor) + count) % count;
    return {{lower, (lower + 1) % count}, static_cast<float>(at - floor)};
}

}  // namespace

/// Between two looks at whether to go on: some milliseconds.
constexpr std::size_t kCellsAtOnce = 1 << 16;

struct MeasuredMerl::Tables {
    Tables(const MerlTable& table, SharedProgress* work);

    int half, difference, azimuths;
    std::vector<Rgb> values;  ///< 1/sr; negative red: not measured
    std::array<Row, kRows> rows;

    Rgb rgb(Vec3f wi, Vec3f wo) const;
    /// Row of an incident direction, and the fraction of the way to the next.
    static std::pair<int, float> locate(Vec3f wi) {
        const float at =
            std::atan2(std::sqrt(wi.x * wi.x + wi.y * wi.y), wi.z) * ((kRows - 1) / (0.5f * kPiF));
        const int row = std::clamp(static_cast<int>(at), 0, kRows - 2);
        return {row, std::clamp(at - row, 0.0f, 1.0f)};
    }
    static std::array<float, kStrategies> densities(Vec3f wi, Vec3f wo) {
        std::array<float, kStrategies> d;
        for (std::size_t k = 0; k < kLobes.size(); ++k) d[k] = kLobes[k].pdf(wi, wo);
        d.back() = wo.z / kPiF;
        return d;
    }
    const Probability& probability(Vec3f wi) const {
        const auto [row, fraction] = locate(wi);
        return rows[row + (fraction > 0.5f)].probability;
    }
    float density(Vec3f wi, Vec3f wo) const {
        const Probability& p = probability(wi);
        const std::array<float, kStrategies> d = densities(wi, wo);
        float sum = 0;
        for (std::size_t k = 0; k < kStrategies; ++k) sum += p[k] * d[k];
        return sum;
    }

 private:
    Row fit_row(float theta_i) const;
};

MeasuredMerl::Tables::Tables(const MerlTable& table, SharedProgress* work)
    : half(table.half), difference(table.difference), azimuths(table.azimuths) {
    validate(table);
    values.resize(table.cells());
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (work && i % kCellsAtOnce == 0) work->throw_if_stopped("preparing a measured BRDF");
        for (int c = 0; c < 3; ++c) {
            const double v = table.values[c * values.size() + i];
            // A cell counts as measured if all its channels do.
            if (v < 0) {
                values[i] = {-1, -1, -1};
                break;
            }
            values[i][c] = static_cast<float>(v * MerlTable::kScale[c]);
        }
    }
    parallel_for(0, kRows, [&](std::size_t row) {
        rows[row] = fit_row(0.5f * kPiF * std::min(row / (kRows - 1.0f), 0.9999f));
    });
}

Rgb MeasuredMerl::Tables::rgb(Vec3f wi, Vec3f wo) const {
    const HalfDifference at = half_difference(wi, wo);
    const Neighbours h = neighbours(std::sqrt(at.theta_half / (0.5 * kPiF)) * half, half);
    const Neighbours d = neighbours(at.theta_difference / (0.5 * kPiF) * difference, difference);
    const Neighbours a = periodic_neighbours(at.phi_difference / kPiF * azimuths, azimuths);
    Rgb sum{};
    float all = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const int i = corner & 1, j = corner >> 1 & 1, k = corner >> 2;
        const Rgb& cell =
            values[(static_cast<std::size_t>(h.cell[i]) * difference + d.cell[j]) * azimuths +
                   a.cell[k]];
        if (cell[0] < 0) continue;
        const float weight = (i ? h.fraction : 1 - h.fraction) * (j ? d.fraction : 1 - d.fraction) *
                             (k ? a.fraction : 1 - a.fraction);
        all += weight;
        sum += weight * cell;
    }
    if (!(all > 0)) return {};
    return sum / all;
}

// Points are half vectors, dense near the normal like the cells of the table: with
// theta_h = (pi/2) x^2 the solid angle of wo is 4 w_i.h 2 pi^2 x sin(theta_h) dx dphi/(2 pi).
Row MeasuredMerl::Tables::fit_row(float theta_i) const {
    constexpr int kPolar = 128, kAzimuth = 64;
    const Vec3f wi = {std::sin(theta_i), 0, std::cos(theta_i)};
    std::vector<FluxPoint<kStrategies>> points;
    points.reserve(kPolar * kAzimuth);
    Vec3d albedo;
    for (int p = 0; p < kPolar; ++p) {
        const float x = (p + 0.5f) / kPolar, theta = 0.5f * kPiF * x * x, sine = std::sin(theta);
        for (int q = 0; q < kAzimuth; ++q) {
            const float phi = kPiF * (q + 0.5f) / kAzimuth;
            const Vec3f h = {sine * std::cos(phi), sine * std::sin(phi), std::cos(theta)};
            const float cosine = dot(wi, h);
            const Vec3f wo = 2 * cosine * h - wi;
            if (cosine <= 0 || wo.z <= 0) continue;
            const double weight =
                4.0 * cosine * 2 * kPiF * kPiF * x * sine / (kPolar * kAzimuth) * wo.z;
            const Rgb f = rgb(wi, wo);
            albedo += weight * to_double(f);
            points.push_back({weight * (f[0] + f[1] + f[2]), densities(wi, wo)});
        }
    }
    Row row;
    row.albedo = to_float(albedo);
    std::array<double, kStrategies> fraction;
    fraction.fill(1.0 / kStrategies);
    fraction = fit_mixture(points, fraction);
    // A fiftieth, at least, goes to the cosine lobe and as much to the widest other: that bounds
    // the weights.
    constexpr double kMin = 0.02;
    double all = 0;
    for (std::size_t k = kStrategies - 2; k < kStrategies; ++k)
        fraction[k] = std::max(fraction[k], kMin);
    for (double s : fraction) all += s;
    for (std::size_t k = 0; k < kStrategies; ++k)
        row.probability[k] = static_cast<float>(fraction[k] / all);
    return row;
}

namespace {

// The model at eight wavelengths.
class BoundMeasuredMerl final : public BoundBsdf {
 public:
    BoundMeasuredMerl(std::shared_ptr<const MeasuredMerl::Tables> tables,
                      const Wavelengths& wavelengths)
        : tables_(std::move(tables)), spectrum_(wavelengths) {}

    FloatLanes eval(Vec3f wi, Vec3f wo) const override {
        if (wi.z <= 0 || wo.z <= 0) return FloatLanes{};
        return spectrum_(tables_->rgb(wi, wo));
    }

    float pdf(Vec3f wi, Vec3f wo) const override {
        return wi.z > 0 && wo.z > 0 ? tables_->density(wi, wo) : 0;
    }

    std::optional<BsdfSample> sample(Vec3f wi, float u_select, Vec2f u) const override {
        if (wi.z <= 0) return std::nullopt;
        const Vec3f wo = draw(wi, u_select, u);
        if (wo.z <= 0) return std::nullopt;
        BsdfSample s;
        s.wo = wo;
        s.pdf = tables_->density(wi, wo);
        if (!(s.pdf > 0)) return std::nullopt;
        s.weight = eval(wi, wo) * (wo.z / s.pdf);
        return s;
    }

    FloatLanes albedo(Vec3f wi) const override {
        if (wi.z <= 0) return FloatLanes{};
        const auto [row, fraction] = MeasuredMerl::Tables::locate(wi);
        const Rgb &a = tables_->rows[row].albedo, &b = tables_->rows[row + 1].albedo;
        return spectrum_(a + fraction * (b - a));
    }

 private:
    Vec3f draw(Vec3f wi, float u_select, Vec2f u) const {
        const Probability& probability = tables_->probability(wi);
        for (std::size_t k = 0; k < kLobes.size(); ++k) {
            if (u_select < probability[k])
                return kLobes[k].sample(wi, u_select / probability[k], u);
            u_select -= probability[k];
        }
        return cosine_hemisphere(u);
    }

    std::shared_ptr<const MeasuredMerl::Tables> tables_;
    RgbLanes spectrum_;
};

}  // namespace

MeasuredMerl::MeasuredMerl(const MerlTable& table, SharedProgress* work)
    : tables_(std::make_shared<const Tables>(table, work)) {}

MeasuredMerl::~MeasuredMerl() = default;

std::unique_ptr<const BoundBsdf> MeasuredMerl::bind(const Wavelengths& wavelengths_nm) const {
    return std::make_unique<const BoundMeasuredMerl>(tables_, wavelengths_nm);
}

}  // namespace nacre::bsdf
