#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nacre/bsdf/models/bound_microflake.h"
#include "nacre/bsdf/models/paint_table.h"
#include "nacre/bsdf/tabulated/tabulated.h"
#include "nacre/bsdf/warp.h"
#include "nacre/core/error.h"
#include "nacre/core/lane_math.h"
#include "nacre/core/quadrature.h"
#include "nacre/core/random.h"
#include "nacre/optics/fresnel.h"
#include "nacre/paint/beckmann.h"
#include "nacre/solver/solver.h"

namespace nacre::bsdf {

namespace {

constexpr std::string_view kTableNames[] = {"split", "raw", "svd"};

constexpr ModelOption table_option() {
    ModelOption option = OptionFor<&MicroflakeModel::table>::choice(
        "--table",
        "microflake: how the solved BRDF is kept: split (spectral, exact), or raw or svd (RGB "
        "tables as in the comparison of 2022)",
        kTableNames);
    option.of_solution = true;
    return option;
}
constexpr ModelOption kMicroflakeOptions[] = {table_option()};

}  // namespace

constinit const ModelInfo MicroflakeModel::info = {
    .name = "microflake",
    .summary = "flakes in layers, solved by radiative transfer: a smooth mean over many flakes",
    .source = "Ergun et al. 2016",
    .ingredients = Ingredients::layers,
    .solution = Solution::table,
    .can = {.goniochromism = true, .multiple_scattering = true, .parts = true},
    .standard = standard_model<MicroflakeModel>,
    .options = kMicroflakeOptions};

std::string MicroflakeModel::text() const {
    return fmt::format(
        "table={} angles={} azimuths={} rank={} tolerance={} clip_to_gamut={} specimen={}",
        kTableNames[static_cast<int>(table)], table_size.angles, table_size.azimuths,
        compression.rank, compression.tolerance, compression.clip_to_gamut, specimen);
}

std::shared_ptr<const Bsdf> MicroflakeModel::make(const ModelInput& input,
                                                  const Progress& progress) const {
    if (input.table) return std::make_shared<const Tabulated>(*input.table);
    if (makes_table()) {
        return std::make_shared<const Tabulated>(*make_table(*input.solved, progress));
    }
    return std::make_shared<const Microflake>(input.solved, specimen, progress);
}

std::optional<BrdfTable> MicroflakeModel::make_table(const solver::SolvedPaint& paint,
                                                     const Progress& progress) const {
    if (!makes_table()) return std::nullopt;
    if (paint.recipe.orange_peel()) {
        throw DomainError(
            fmt::format("table = {}: tables are of a flat coat, and this paint has a "
                        "clearcoat.orange_peel; must be "
                        "split",
                        kTableNames[static_cast<int>(table)]));
    }
    if (paint.recipe.coat_spread() > 0) {
        throw DomainError(fmt::format(
            "table = {}: tables are of an even coat, and this paint has a "
            "clearcoat.thickness_spread_um of {}; must be split",
            kTableNames[static_cast<int>(table)], paint.recipe.clearcoat->thickness_spread_um));
    }
    paint::require_no_lean(
        paint.recipe, fmt::format("table = {}: tables are", kTableNames[static_cast<int>(table)]));
    RawBrdfTable raw = make_raw_table(paint, table_size, progress);
    if (table == Table::svd) {
        return std::make_shared<const CompressedBrdfTable>(compress(raw, compression));
    }
    return std::make_shared<const RawBrdfTable>(std::move(raw));
}

void MicroflakeModel::require_kind(const BrdfTable& read, const std::string& file) const {
    const Table kind =
        std::holds_alternative<std::shared_ptr<const RawBrdfTable>>(read) ? Table::raw : Table::svd;
    if (makes_table() && table != kind) {
        const auto name = [](Table t) { return kTableNames[static_cast<int>(t)]; };
        throw DomainError(fmt::format("table = {}: {} holds a table of the kind {}", name(table),
                                      file, name(kind)));
    }
}

std::optional<sparkle::CoatWaves> coat_waves(const solver::SolvedPaint& paint,
                                             std::uint64_t specimen) {
    const auto peel = paint.recipe.orange_peel();
    if (!peel) return std::nullopt;
    return sparkle::CoatWaves(*peel, specimen);
}

std::optional<Vec2f> flake_lean(const solver::SolvedPaint& paint) {
    const auto lean = paint.recipe.flake_lean();
    if (!lean) return std::nullopt;
    if (paint.recipe.clearcoat && paint.recipe.clearcoat->roughness > 0) {
        throw DomainError(
            fmt::format("lean.tilt_deg = {}: must be 0 under a rough interface, of "
                        "clearcoat.roughness = {}",
                        lean->tilt_deg, paint.recipe.clearcoat->roughness));
    }
    const auto [x, y] = lean->tangents();
    return Vec2f{static_cast<float>(x), static_cast<float>(y)};
}

std::optional<sparkle::CoatThickness> coat_thickness(const solver::SolvedPaint& paint,
                                                     std::uint64_t specimen) {
    if (paint.recipe.coat_spread() == 0) return std::nullopt;
    return sparkle::CoatThickness(specimen);
}

Microflake::Microflake(std::shared_ptr<const solver::SolvedPaint> paint, std::uint64_t specimen,
                       const Progress& progress)
    : waves_(bsdf::coat_waves(*paint, specimen)),
      thickness_(bsdf::coat_thickness(*paint, specimen)),
      lean_(bsdf::flake_lean(*paint)) {
    auto tables = std::make_shared<Tables>(std::move(paint));
    if (thickness_ || lean_) {
        SharedProgress work(progress, 1);
        if (thickness_) tables->coat_spread.emplace(*tables->paint, false, work);
        if (lean_) tables->leaning.emplace(*tables->paint, work);
    }
    tabulate_sampling(*tables, [&](const Wavelengths& wavelengths_nm) {
        return std::make_unique<const BoundMicroflake>(tables, wavelengths_nm);
    });
    tables_ = std::move(tables);
}

Microflake::~Microflake() = default;

std::unique_ptr<const BoundBsdf> Microflake::bind(const Wavelengths& wavelengths_nm) const {
    return std::make_unique<const BoundMicroflake>(tables_, wavelengths_nm);
}

float mean_ior(const solver::PaintMedium& medium) { return static_cast<float>(mean_index(medium)); }

Microflake::Tables::Tables(std::shared_ptr<const solver::SolvedPaint> solved)
    : Tables(solved, extinction_by_direction(solved->medium)) {}

Microflake::Tables::Tables(std::shared_ptr<const solver::SolvedPaint> solved,
                           std::vector<std::vector<float>> extinction_per_um)
    : paint(std::move(solved)),
      mean_ior(bsdf::mean_ior(paint->medium)),
      rough(has_rough_interface(*paint)),
      smooth(smooth_table(*paint)),
      extinction(std::move(extinction_per_um)) {}

BoundMicroflake::BoundMicroflake(std::shared_ptr<const Microflake::Tables> tables,
                                 const Wavelengths& wavelengths)
    : tables_(std::move(tables)),
      where_(locate_wavelengths(tables_->paint->wavelengths_nm(), wavelengths)),
      grid_(tables_->smooth.grid()) {
    const solver::SolvedPaint& paint = *tables_->paint;
    smooth_ = bind_table(tables_->smooth, paint, where_);
    if (tables_->leaning) leaning_.emplace(*tables_->leaning, where_);
    if (tables_->coat_spread) coat_spread_ = BoundCoatSpread(*tables_->coat_spread, where_);
    clearcoat_depth_ =
        at_wavelengths(where_, [&](int w) { return paint.medium.clearcoat_depth[w]; });
    ior_ = at_wavelengths(where_, [&](int w) { return paint.medium.ior[w]; });
    inverse_ior2_ = 1.0f / (ior_ * ior_);
    mean_ior_ = tables_->mean_ior;
    for (int i = 0; i < kLanes; ++i) dispersive_ = dispersive_ || ior_[i] != mean_ior_;
    inverse_mean_ior_ = 1 / mean_ior_;

    if (tables_->rough) {
        rough_ = Rough{InterfaceLobe(paint.medium.roughness, ior_, mean_ior_), {}};
    } else {
        bind_smooth_interface();
        bind_layers();
    }
}

void BoundMicroflake::bind_rough_single() {
    if (!rough_) return;
    rough_->single = bind_table(tables_->smooth, *tables_->paint, where_, true);
    coat_ = sparkle::CoatTilt(tables_->paint->medium.roughness, mean_ior_);
    bind_layers();
}

void BoundMicroflake::bind_smooth_interface() {
    for (int row = 0; row <= kDirectionIntervals; ++row) {
        const Ray ray = bsdf::make_ray(direction_angle(row), 0.0, inverse_mean_ior_);
        const double cosine = ray.outside.z;
        const DoubleLanes transmittance =
            1.0 - optics::dielectric_reflectance(splat(1.0), to_double(ior_), splat(cosine));
        scaled_transmittance_.push_back(to_float(transmittance) / transmittance_scale(ray));
    }
}

// Single scattering in closed form.
void BoundMicroflake::bind_layers() {
    const solver::SolvedPaint& paint = *tables_->paint;
    const int count = tables_->wavelength_count();
    for (std::size_t n = 0; n < paint.medium.layers.size(); ++n) {
        const solver::LayerMedium& medium = paint.medium.layers[n];
        BoundLayer& layer = layers_.emplace_back();
        layer.thickness_um = static_cast<float>(medium.thickness_um);
        for (int row = 0; row <= kDirectionIntervals; ++row) {
            layer.extinction.push_back(at_wavelengths(
                where_, [&](int w) { return tables_->extinction[n][row * count + w]; }));
        }
        float thinnest = INFINITY;
        for (const FloatLanes& extinction : layer.extinction) {
            thinnest = std::min(thinnest, -lane_max(-extinction) * layer.thickness_um);
        }
        layer.thick = thinnest > 0.1f;  // along the normal; slant paths are deeper
        layer.buried = n > 0 || lane_max(clearcoat_depth_) > 0;
        for (const solver::FlakeMedium& flake : medium.flakes) {
            const float alpha2 = static_cast<float>(flake.alpha * flake.alpha);
            BoundFlake& out = layer.flakes.emplace_back();
            out.half_density = static_cast<float>(0.5 * flake.area_density_per_um);
            out.inverse_alpha2 = 1 / alpha2;
            out.norm = 0.5f * std::numbers::inv_pi_v<float> / alpha2;
            out.intervals = flake.table.cosine_count() > 1 ? paint::FlakeTable::kFineIntervals : 0;
            for (int c = 0; c <= out.intervals; ++c) {
                const double* row = flake.table.fine_reflectance(c);
                out.reflectance.push_back(at_wavelengths(where_, [&](int w) { return row[w]; }));
            }
        }
        for (const solver::PigmentMedium& pigment : medium.pigments) {
            layer.pigments.push_back(
                {static_cast<float>(pigment.anisotropy),
                 at_wavelengths(where_, [&](int w) { return pigment.scattering_per_um[w]; }),
                 pigment.phase ? &*pigment.phase : nullptr});
        }
    }
}

template FloatLanes BoundMicroflake::value(const Ray&, const Ray&, const MeanFlakes&) const;
template FloatLanes BoundMicroflake::single(Vec3f, Vec3f, const Ray&, const Ray&,
                                            const MeanFlakes&) const;

Ray make_ray(Vec3f w, float inverse_mean_ior) {
    Ray ray;
    ray.outside = w;
    ray.inside = refract_in(w, inverse_mean_ior);
    ray.sine = std::sqrt(w.x * w.x + w.y * w.y);
    ray.x = ray.sine / (1 + w.z);
    const float at = ray.x * kDirectionIntervals;
    ray.row = std::min(static_cast<int>(at), kDirectionIntervals - 1);
    ray.fraction = at - ray.row;
    return ray;
}

Ray make_ray(double theta, double phi, float inverse_mean_ior) {
    const double sine = std::sin(theta);
    return make_ray({static_cast<float>(sine * std::cos(phi)),
                     static_cast<float>(sine * std::sin(phi)), static_cast<float>(std::cos(theta))},
                    inverse_mean_ior);
}

const SamplingProbabilities& BoundMicroflake::probabilities_at(const Ray& i) const {
    return tables_->probability[i.row + (i.fraction > 0.5f)];
}

template <class T>
T BoundMicroflake::density(const SamplingProbabilities& probability, const Ray& i,
                           const Vec3<T>& outside, const Vec3<T>& inside) const {
    const T x = i.inside.x + inside.x, y = i.inside.y + inside.y, z = i.inside.z + inside.z;
    const Vec3<T> half = {x, y, z};
    const T slopes = tables_->warp->slope_pdf({i.outside, i.inside, i.x}, half);
    // Area of slopes per solid angle of w_o: sec^3 / (4 w_i.h), and that outside.
    const T table =
        slopes * solid_angle_ratio(outside.z, inside.z) * 0.5f * dot(half, half) / (z * z * z);
    T interface {};
    if (rough_) interface = probability.interface * rough_->interface.pdf(i.outside, outside);
    return interface + probability.table * table +
           probability.diffuse * std::numbers::inv_pi_v<float> * outside.z;
}

FloatLanes BoundMicroflake::coat_depth_of_deviation(const Ray& i, const Ray& o) const {
    const auto inverse_mu = [&](const Ray& ray) {
        return 1.0f /
               sqrt_lanes(max_lanes(1.0f - ray.sine * ray.sine * inverse_ior2_, splat(1e-6f)));
    };
    return coat_spread_.spread() * clearcoat_depth_ * (inverse_mu(i) + inverse_mu(o));
}

FloatLanes BoundMicroflake::coat_factor(Vec3f wi, Vec3f wo, float deviation) const {
    return exp_lanes(-deviation * coat_depth_of_deviation(make_ray(wi), make_ray(wo)));
}

CoatChange BoundMicroflake::coat_change(Vec3f wi, Vec3f wo, float deviation) const {
    const Ray i = make_ray(wi), o = make_ray(wo);
    return coat_change(i, o, deviation, coat_nodes(i, o));
}

CoatNodes BoundMicroflake::coat_nodes(const Ray& i, const Ray& o) const {
    if (coat_spread_.spread() == 0) return {};
    return {tabulated(smooth_, i, o), tabulated(coat_spread_.thinner(), i, o),
            tabulated(coat_spread_.thicker(), i, o)};
}

// Light in closed form crosses the coat once on its way in and once out; what the table holds is more:
// CoatSpread.
CoatChange BoundMicroflake::coat_change(const Ray& i, const Ray& o, float deviation,
                                        const CoatNodes& table) const {
    const FloatLanes depth = coat_depth_of_deviation(i, o);
    CoatChange change{exp_lanes(-deviation * depth), {}};
    const FloatLanes more =
        table.mean * (relative_multiple_scattering(table, depth, deviation) - 1.0f);
    if (rough_) {
        // The lobe of the interface does not cross the coat.
        change.added = change.factor * more + (1.0f - change.factor) * rough_->interface.eval(i, o);
    } else {
        change.added = change.factor * more * interface_factor(i, o);
    }
    return change;
}

FloatLanes BoundMicroflake::eval(Vec3f wi, Vec3f wo) const {
    if (wi.z <= 0 || wo.z <= 0) return FloatLanes{};
    return value(make_ray(wi), make_ray(wo), MeanFlakes{});
}

MultiplyScattered BoundMicroflake::multiply_scattered(Vec3f wi, Vec3f wo) const {
    return multiple_value(make_ray(wi), make_ray(wo), MeanFlakes{});
}

OpticalDepths BoundMicroflake::optical_depths(float cosine) const {
    return leaning_ ? leaning_->depths(cosine) : OpticalDepths{};
}

float BoundMicroflake::pdf(Vec3f wi, Vec3f wo) const {
    if (wi.z <= 0 || wo.z <= 0) return 0;
    const Ray i = make_ray(wi);
    return density(probabilities_at(i), i, make_ray(wo));
}

FloatLanes BoundMicroflake::pdf_lanes(Vec3f wi, const Vec3Lanes& wo) const {
    if (wi.z <= 0) return FloatLanes{};
    const Ray i = make_ray(wi);
    // Those below the horizon are taken somewhere above, and left out then.
    const Vec3Lanes above = {wo.x, wo.y, max_lanes(wo.z, splat(1e-6f))};
    const FloatLanes pdf =
        density(probabilities_at(i), i, above, refract_in(above, inverse_mean_ior_));
    return wo.z > 0 ? pdf : FloatLanes{};
}

UnitRange BoundMicroflake::interface_lobe_range(const Patch* /*patch*/, Vec3f wi) const {
    if (!rough_ || wi.z <= 0) return {};
    return {0, probabilities_at(make_ray(wi)).interface};
}

float BoundMicroflake::specular_probability(Vec3f wi) const {
    return rough_ || wi.z <= 0 ? 0.0f : probabilities_at(make_ray(wi)).interface;
}

BsdfValue BoundMicroflake::evaluate(Vec3f wi, Vec3f wo) const {
    if (wi.z <= 0 || wo.z <= 0) return {};
    const Ray i = make_ray(wi), o = make_ray(wo);
    return {value(i, o, MeanFlakes{}), density(probabilities_at(i), i, o)};
}

BsdfSample BoundMicroflake::specular_sample(Vec3f wi, float probability) const {
    BsdfSample s;
    s.wo = {-wi.x, -wi.y, wi.z};
    s.weight = optics::dielectric_reflectance(splat(1.0f), ior_, splat(wi.z)) * (1 / probability);
    s.pdf = probability;
    s.kind = SampleKind::specular;
    return s;
}

Vec3f BoundMicroflake::draw(const SamplingProbabilities& probability, const Ray& i, float u_select,
                            Vec2f u) const {
    if (u_select < probability.interface)
        return rough_->interface.sample(i.outside, u_select / probability.interface, u);
    if (u_select - probability.interface < probability.diffuse) return cosine_hemisphere(u);
    return tables_->warp->sample({i.outside, i.inside, i.x}, u).value_or(Vec3f{0, 0, 0});
}

std::optional<BsdfSample> BoundMicroflake::sample(Vec3f wi, float u_select, Vec2f u) const {
    if (wi.z <= 0) return std::nullopt;
    const Ray i = make_ray(wi);
    return sample_by(i, u_select, u, [&](const Ray& o) { return value(i, o, MeanFlakes{}); });
}

FloatLanes BoundMicroflake::albedo(Vec3f wi) const {
    if (wi.z <= 0) return FloatLanes{};
    const Ray i = make_ray(wi);
    const int count = tables_->wavelength_count();
    const auto at = [&](int row) {
        return at_wavelengths(where_, [&](int w) { return tables_->albedo[row * count + w]; });
    };
    const FloatLanes a = at(i.row);
    return a + i.fraction * (at(i.row + 1) - a);
}

}  // namespace nacre::bsdf
