#include "nacre/bsdf/models/nacre.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <numbers>

#include "nacre/core/error.h"
#include "nacre/core/lane_math.h"
#include "nacre/core/parallel.h"
#include "nacre/core/quadrature.h"
#include "nacre/core/random.h"
#include "nacre/paint/beckmann.h"
#include "nacre/solver/directions.h"
#include "nacre/sparkle/flake_sizes.h"

namespace nacre::bsdf {
namespace {

sparkle::FlakePopulation population_of(const paint::FlakeSpecies& species,
                                       const paint::Layer& layer, double ior) {
    sparkle::FlakePopulation out;
    out.diameter_um = species.diameter_um;
    out.diameter_spread_um = species.diameter_spread_um;
    out.alpha = species.orientation.beckmann_alpha;
    out.ior = ior;
    constexpr double kSquareUmPerMm2 = 1e6;
    const double area_um2 =
        sparkle::FlakeSizes(species.diameter_um, species.diameter_spread_um).mean_area_um2();
    out.density_per_mm2 =
        species.area_density_per_um() * layer.thickness_um / area_um2 * kSquareUmPerMm2;
    return out;
}

// cos(w_i.h) of any two directions that the interface lets through, each within the critical angle.
double min_half_cosine(double ior) { return std::sqrt(std::max(0.0, 1 - 1 / (ior * ior))); }

// Single scattering of each species at normal incidence, summed over the wavelengths: roughly, as
// orientation is neglected, and up to a common factor.
std::vector<double> returned_light(const Microflake::Tables& tables) {
    const solver::PaintMedium& medium = tables.paint->medium;
    const int count = medium.wavelength_count();
    std::vector<double> returned;
    std::vector<double> depth(count, 0.0);
    for (std::size_t l = 0; l < medium.layers.size(); ++l) {
        const solver::LayerMedium& layer = medium.layers[l];
        std::vector<double> seen(count);  // thickness weighted by the attenuation both ways, um
        for (int w = 0; w < count; ++w) {
            const double here = 2 * tables.extinction[l][w] * layer.thickness_um;
            seen[w] = layer.thickness_um * std::exp(-depth[w]) *
                      (here > 1e-9 ? -std::expm1(-here) / here : 1.0);
            depth[w] += here;
        }
        for (const solver::FlakeMedium& flake : layer.flakes) {
            double sum = 1e-30;
            for (int w = 0; w < count; ++w) {
                sum += seen[w] * flake.area_density_per_um *
                       flake.table.reflectance(1, w / kLanes)[w % kLanes];
            }
            returned.push_back(sum);
        }
    }
    return returned;
}

}  // namespace

Nacre::Tables::Tables(std::shared_ptr<const solver::SolvedPaint> paint, const NacreModel& settings,
                      SharedProgress& work)
    : smooth(std::make_shared<Microflake::Tables>(paint)) {
    const paint::Recipe& recipe = paint->recipe;
    const std::vector<double> returned = returned_light(*smooth);
    double all = 0;
    for (const double r : returned) all += r;
    for (std::size_t l = 0; l < recipe.layers.size(); ++l) {
        first_species.push_back(species.size());
        for (std::size_t f = 0; f < recipe.layers[l].flakes.size(); ++f) {
            const paint::FlakeSpecies& flake = recipe.layers[l].flakes[f];
            std::optional<FlakeFilms> films;
            if (const auto* platelet = std::get_if<optics::Platelet>(&flake.body);
                platelet && FlakeFilms::vary(*platelet)) {
                films.emplace(*platelet, recipe.binder, paint->wavelengths_nm(),
                              min_half_cosine(smooth->mean_ior), &work);
            }
            const float fraction = static_cast<float>(returned[species.size()] / all);
            species.push_back(
                {sparkle::FlakeField(population_of(flake, recipe.layers[l], smooth->mean_ior),
                                     hash_of(settings.specimen, l, f)),
                 std::move(films), fraction});
        }
    }
    if (settings.hot_spot) hot_spot.emplace(*paint);
}

Nacre::Nacre(std::shared_ptr<const solver::SolvedPaint> paint, const NacreModel& settings,
             const Progress& progress) {
    if (paint->medium.roughness > 0) {
        throw DomainError(
            fmt::format("clearcoat.roughness = {}: the model nacre needs a smooth clearcoat, with "
                        "roughness = 0",
                        paint->medium.roughness));
    }
    SharedProgress work(progress, 1);
    work.add(0);
    auto tables = std::make_shared<Tables>(std::move(paint), settings, work);
    tabulate_albedo(*tables->smooth, [&](const Wavelengths& wavelengths_nm) {
        return std::make_unique<const BoundNacre>(tables, wavelengths_nm);
    });
    tables_ = std::move(tables);
}

Nacre::~Nacre() = default;

double Nacre::exact_patch_mm() const {
    double side = std::numeric_limits<double>::infinity();
    for (const NacreSpecies& species : tables_->species) {
        side = std::min(side, species.field.exact_side_mm());
    }
    return side;
}

std::unique_ptr<const BoundBsdf> Nacre::bind(const Wavelengths& wavelengths_nm) const {
    return std::make_unique<const BoundNacre>(tables_, wavelengths_nm);
}

namespace {

// The mean of d weighted by the area of the flakes: Int O dz of a flake goes with area times d.
float mean_diameter_um(const paint::FlakeSpecies& species) {
    const sparkle::FlakeSizes sizes(species.diameter_um, species.diameter_spread_um);
    double square = 0, cube = 0;
    for (int i = 0; i < sparkle::FlakeSizes::kSizes; ++i) {
        const double d = sizes.diameter_um(i);
        square += d * d;
        cube += d * d * d;
    }
    return static_cast<float>(cube / square);
}

// c Int (1-T)^2 |w.m| D(m) dm / mu at the wavelengths of one block.
DoubleLanes shared_blocking(const solver::FlakeMedium& flake, double mu, int block) {
    DoubleLanes sum{};
    paint::for_each_normal(mu, flake.alpha, [&](double cosine, double weight) {
        const DoubleLanes blocked = 1.0 - flake.table.transmittance(cosine, block);
        sum += weight * blocked * blocked;
    });
    return flake.area_density_per_um / mu * sum;
}

}  // namespace

HotSpotTables::HotSpotTables(const solver::SolvedPaint& paint)
    : wavelength_count_(paint.medium.wavelength_count()) {
    const solver::PaintMedium& medium = paint.medium;
    float top_um = 0;
    for (std::size_t l = 0; l < medium.layers.size(); ++l) {
        top_um_.push_back(top_um);
        thickness_um_.push_back(static_cast<float>(medium.layers[l].thickness_um));
        top_um += thickness_um_.back();
        for (std::size_t f = 0; f < medium.layers[l].flakes.size(); ++f) {
            const solver::FlakeMedium& flake = medium.layers[l].flakes[f];
            Species& species = species_.emplace_back();
            species.layer = l;
            species.diameter_um = mean_diameter_um(paint.recipe.layers[l].flakes[f]);
            species.coupling.resize(static_cast<std::size_t>(kDirectionIntervals + 1) *
                                    wavelength_count_);
            parallel_for(0, kDirectionIntervals + 1, [&](std::size_t row) {
                const double theta = direction_angle(static_cast<int>(row));
                for (int w = 0; w < wavelength_count_; ++w) {
                    const double mu = solver::inside_cosine(medium.ior[w], theta);
                    species.coupling[row * wavelength_count_ + w] = static_cast<float>(
                        std::sqrt(shared_blocking(flake, mu, w / kLanes)[w % kLanes]));
                }
            });
        }
    }
}

double disc_overlap_integral(double x) {
    constexpr double kFullOverlap = 4 / (3 * std::numbers::pi);
    if (x >= 1) return kFullOverlap;
    const double chord2 = 1 - x * x, chord = std::sqrt(chord2);
    return 2 * std::numbers::inv_pi * (x * std::acos(x) - chord + chord * chord2 / 3 + 2.0 / 3);
}

HotSpot::HotSpot(const HotSpotTables& tables, const std::array<WavelengthPosition, kLanes>& where)
    : top_um_(tables.top_um_), thickness_um_(tables.thickness_um_) {
    for (const HotSpotTables::Species& from : tables.species_) {
        Species& to = species_.emplace_back();
        to.layer = from.layer;
        to.diameter_um = from.diameter_um;
        for (int row = 0; row <= kDirectionIntervals; ++row) {
            const float* values =
                from.coupling.data() + static_cast<std::size_t>(row) * tables.wavelength_count_;
            to.coupling.push_back(at_wavelengths(where, [&](int w) { return values[w]; }));
        }
    }
}

HotSpot::Pair::Pair(const HotSpot& hot_spot, const Ray& i, const Ray& o)
    : hot_spot_(&hot_spot), i_(&i), o_(&o) {
    const float x = i.inside.x / i.inside.z - o.inside.x / o.inside.z;
    const float y = i.inside.y / i.inside.z - o.inside.y / o.inside.z;
    // Beyond the upper bound, at grazing incidence without a coat, the integrals below are nil; at
    // the lower one they are those of rays that coincide.
    spread_ = std::clamp(std::sqrt(x * x + y * y), 1e-4f, 1e6f);
}

template <class Add>
void HotSpot::Pair::for_each_species(std::size_t layer, Add&& add) const {
    const HotSpot& h = *hot_spot_;
    for (const Species& s : h.species_) {
        if (s.layer > layer) break;
        // Heights between which the species lies, from the flake upwards, in um.
        const float over_top = h.top_um_[layer] - h.top_um_[s.layer];
        const float within = s.layer == layer ? 0.0f : h.thickness_um_[s.layer];
        const float step = spread_ / s.diameter_um;
        add(i_->look_up(s.coupling) * o_->look_up(s.coupling), [=, &h](float u) {
            const float far = u * h.thickness_um_[layer] + over_top;
            const float near = within > 0 ? far - within : 0.0f;
            return static_cast<float>(
                (disc_overlap_integral(far * step) - disc_overlap_integral(near * step)) / step);
        });
    }
}

FloatLanes HotSpot::Pair::gain(std::size_t layer, float u) const {
    FloatLanes sum{};
    for_each_species(layer, [&](const FloatLanes& coupling, auto&& length_um) {
        sum += coupling * length_um(u);
    });
    return sum;
}

FloatLanes HotSpot::Pair::mean(std::size_t layer, const FloatLanes& depth) const {
    // What comes from below 24 optical depths, 12 with all of the gain, is 6e-6 of the whole.
    constexpr float kDeep = 24;
    constexpr int kNodes = 16;
    const Quadrature& rule = unit_gauss_legendre(kNodes);
    const FloatLanes safe = max_lanes(depth, splat(1e-20f));
    const float reach = std::min(1.0f, kDeep / -lane_max(-safe));
    std::array<FloatLanes, kNodes> exponent;
    for (int n = 0; n < kNodes; ++n) {
        exponent[n] = -safe * (reach * static_cast<float>(rule.nodes[n]));
    }
    for_each_species(layer, [&](const FloatLanes& coupling, auto&& length_um) {
        for (int n = 0; n < kNodes; ++n) {
            exponent[n] += coupling * length_um(reach * static_cast<float>(rule.nodes[n]));
        }
    });
    FloatLanes sum{};
    for (int n = 0; n < kNodes; ++n) {
        sum += static_cast<float>(rule.weights[n]) * exp_lanes(exponent[n]);
    }
    return sum * reach * safe / one_minus_exp_lanes(safe);
}

namespace {

// On a patch the flake lobe of the mean keeps at least this fraction of its probability: multiple
// scattering follows that lobe too, and it bounds the weights of directions for which no single
// flake is sampled.
constexpr float kMinMeanProbability = 0.1f;

// The half vector inside, as the flakes see it.
struct HalfVector {
    Vec2f slope;
    float slope2, cosine;   // cosine: w_i . h
    float per_solid_angle;  // area of slopes per solid angle of w_o

    HalfVector(const Ray& i, const Ray& o) {
        const Vec3f sum = i.inside + o.inside;
        const float inverse = 1 / sum.z;
        slope = {sum.x * inverse, sum.y * inverse};
        slope2 = slope.x * slope.x + slope.y * slope.y;
        const float sec2 = 1 + slope2;
        cosine = std::min(1.0f, 0.5f * sum.z * std::sqrt(sec2));
        // sec^3 / (4 w_i.h): area of slopes per solid angle of h over solid angle of w_o per that.
        per_solid_angle = 0.5f * inverse * sec2;
    }
};

}  // namespace

// In place of MeanFlakes: the mean of all flakes, with the hot spot.
class BoundNacre::MeanHotSpot {
 public:
    MeanHotSpot(const HotSpot& hot_spot, const Ray& i, const Ray& o) : pair_(hot_spot, i, o) {}
    FloatLanes factor(std::size_t layer, std::size_t, const FloatLanes& depth) const {
        return pair_.mean(layer, depth);
    }

 private:
    HotSpot::Pair pair_;
};

// In place of MeanFlakes: those of a patch.
class BoundNacre::FlakesOfPatch {
 public:
    FlakesOfPatch(const BoundNacre& surface, const Look& look, const Ray& i, const Ray& o)
        : surface_(surface), look_(look), half_(i, o) {
        if (surface.hot_spot_) pair_.emplace(*surface.hot_spot_, i, o);
    }

    FloatLanes factor(std::size_t layer, std::size_t flake, const FloatLanes& depth) const {
        const std::size_t at = surface_.tables_->first_species[layer] + flake;
        const sparkle::DiffractionLobe& lobe = surface_.tables_->species[at].field.lobe();
        if (!lobe.reaches(half_.slope2)) return pair_ ? pair_->mean(layer, depth) : splat(1.0f);
        const sparkle::FlakeView& view = look_[at];
        FloatLanes reflected{};
        bool any = false;
        const float background =
            view.for_each_answer(lobe, half_.slope, half_.cosine, [&](int k, float fraction) {
                any = true;
                const sparkle::FlakeView::Body body = view.body(k);
                FloatLanes exponent = -body.depth * depth;
                if (pair_) exponent += pair_->gain(layer, body.depth);
                FloatLanes of_flake = fraction * exp_lanes(exponent);
                const BoundFlakeFilms& films = surface_.films_[at];
                if (films.vary()) of_flake *= films.ratio(half_.cosine, body.film);
                reflected += of_flake;
            });
        FloatLanes sum = splat(background);
        if (pair_ && background > 0) sum *= pair_->mean(layer, depth);
        if (any) {
            const FloatLanes safe = max_lanes(depth, splat(1e-20f));
            sum += reflected * (safe / one_minus_exp_lanes(safe));
        }
        return sum;
    }

 private:
    const BoundNacre& surface_;
    const Look& look_;
    HalfVector half_;
    std::optional<HotSpot::Pair> pair_;
};

BoundNacre::Look::Look(const BoundNacre& surface, const Patch& patch)
    : own_(patch.memory ? 0 : surface.patch_memory_bytes()) {
    using sparkle::FlakeView;
    PatchMemory& memory = patch.memory ? *patch.memory : own_;
    FlakeView* const views = reinterpret_cast<FlakeView*>(memory.data());
    views_ = views;
    if (memory.filled) return;
    const std::vector<NacreSpecies>& species = surface.tables_->species;
    for (std::size_t s = 0; s < species.size(); ++s) {
        species[s].field.look(patch.footprint, *new (views + s) FlakeView);
    }
    memory.filled = true;
}

BoundNacre::BoundNacre(std::shared_ptr<const Nacre::Tables> tables, const Wavelengths& wavelengths)
    : BoundMicroflake(tables->smooth, wavelengths), tables_(std::move(tables)) {
    for (const NacreSpecies& species : tables_->species) {
        films_.push_back(species.films ? species.films->bind(where()) : BoundFlakeFilms());
    }
    if (tables_->hot_spot) hot_spot_.emplace(*tables_->hot_spot, where());
}

FloatLanes BoundNacre::mean_value(const Ray& i, const Ray& o) const {
    return hot_spot_ ? value(i, o, MeanHotSpot(*hot_spot_, i, o)) : value(i, o, MeanFlakes{});
}

FloatLanes BoundNacre::value_on(const Look& look, const Ray& i, const Ray& o) const {
    return value(i, o, FlakesOfPatch(*this, look, i, o));
}

BoundNacre::Probability BoundNacre::probability_on(const Look& look, const Ray& i) const {
    const LobeProbabilities& mean = probabilities_at(i);
    float background = 0, resolved = 0;
    for (std::size_t s = 0; s < tables_->species.size(); ++s) {
        const float fraction = tables_->species[s].fraction;
        background += fraction * look[s].background;
        resolved += fraction * look[s].weight_sum;
    }
    Probability probability;
    probability.lobes = mean;
    probability.lobes.flakes *= std::max(background, kMinMeanProbability);
    probability.flakes = mean.flakes * resolved;
    const float scale =
        1 / (probability.lobes.interface + probability.lobes.flakes + probability.lobes.wide +
             probability.lobes.diffuse + probability.flakes);
    probability.lobes.interface *= scale;
    probability.lobes.flakes *= scale;
    probability.lobes.wide *= scale;
    probability.lobes.diffuse *= scale;
    probability.flakes *= scale;
    probability.per_species = mean.flakes * scale;
    return probability;
}

std::optional<Vec3f> BoundNacre::draw_flake(const Look& look, const Probability& probability,
                                            const Ray& i, float u_flake, Vec2f u) const {
    float rest = u_flake;
    std::size_t last = 0;
    for (std::size_t s = 0; s < tables_->species.size(); ++s) {
        const float part =
            probability.per_species * tables_->species[s].fraction * look[s].weight_sum;
        if (part == 0) continue;
        last = s;
        if (rest < part) {
            rest /= part;
            break;
        }
        rest -= part;
    }
    const sparkle::FlakeView& view = look[last];
    const Vec2f slope = view.sample_slope(tables_->species[last].field.lobe(), i.inside,
                                          std::min(rest, 0x1.fffffep-1f), u);
    const Vec3f m = normalize(Vec3f{slope.x, slope.y, 1});
    return leave(2 * dot(i.inside, m) * m - i.inside);
}

float BoundNacre::flake_density(const Look& look, const Probability& probability, const Ray& i,
                                const Ray& o) const {
    if (probability.flakes == 0) return 0;
    const HalfVector half(i, o);
    float sum = 0;
    for (std::size_t s = 0; s < tables_->species.size(); ++s) {
        const sparkle::FlakeView& view = look[s];
        if (view.weight_sum == 0) continue;
        const NacreSpecies& species = tables_->species[s];
        sum += species.fraction * view.weight_sum *
               view.slope_pdf(species.field.lobe(), i.inside, half.slope);
    }
    return sum * probability.per_species * half.per_solid_angle * solid_angle_ratio(o);
}

BsdfValue BoundNacre::evaluate_on(const Patch& patch, Vec3f wi, Vec3f wo) const {
    if (wi.z <= 0 || wo.z <= 0) return {};
    if (tables_->species.empty()) return evaluate(wi, wo);
    const Look look(*this, patch);
    const Ray i = make_ray(wi), o = make_ray(wo);
    const Probability probability = probability_on(look, i);
    return {value_on(look, i, o),
            density(probability.lobes, i, o) + flake_density(look, probability, i, o)};
}

std::optional<BsdfSample> BoundNacre::sample_on(const Patch& patch, Vec3f wi, float u_select,
                                                Vec2f u) const {
    if (wi.z <= 0) return std::nullopt;
    if (tables_->species.empty()) return sample(wi, u_select, u);
    const Look look(*this, patch);
    const Ray i = make_ray(wi);
    const Probability probability = probability_on(look, i);
    BsdfSample s;
    if (u_select < probability.flakes) {
        const auto wo = draw_flake(look, probability, i, u_select, u);
        if (!wo) return std::nullopt;
        s.wo = *wo;
    } else {
        u_select -= probability.flakes;
        if (draws_specular(probability.lobes, u_select))
            return specular_sample(wi, probability.lobes.interface);
        s.wo = draw(probability.lobes, i, u_select, u);
        if (s.wo.z <= 0) return std::nullopt;
    }
    const Ray o = make_ray(s.wo);
    s.pdf = density(probability.lobes, i, o) + flake_density(look, probability, i, o);
    if (!(s.pdf > 0)) return std::nullopt;
    s.weight = value_on(look, i, o) * (s.wo.z / s.pdf);
    return s;
}

FloatLanes BoundNacre::eval(Vec3f wi, Vec3f wo) const {
    if (wi.z <= 0 || wo.z <= 0) return FloatLanes{};
    return mean_value(make_ray(wi), make_ray(wo));
}

BsdfValue BoundNacre::evaluate(Vec3f wi, Vec3f wo) const {
    if (wi.z <= 0 || wo.z <= 0) return {};
    const Ray i = make_ray(wi), o = make_ray(wo);
    return {mean_value(i, o), density(probabilities_at(i), i, o)};
}

std::optional<BsdfSample> BoundNacre::sample(Vec3f wi, float u_select, Vec2f u) const {
    auto s = BoundMicroflake::sample(wi, u_select, u);
    if (s && s->kind == SampleKind::density && hot_spot_) {
        s->weight = mean_value(make_ray(wi), make_ray(s->wo)) * (s->wo.z / s->pdf);
    }
    return s;
}

namespace {

constexpr ModelOption kNacreOptions[] = {OptionFor<&NacreModel::hot_spot>::toggle(
    "--hot-spot",
    "nacre: light that came in between large flakes finds the same gaps on its way out; the mean "
    "is then brighter than the solver's")};

}  // namespace

constinit const ModelInfo NacreModel::info = {
    .name = "nacre",
    .summary =
        "single flakes in layers: their light one by one, the rest solved by radiative "
        "transfer",
    .source = "this project",
    .ingredients = Ingredients::layers,
    .solution = Solution::solved,
    .can = {.goniochromism = true, .sparkle = true, .multiple_scattering = true},
    .coordinates = SurfaceCoordinates::object_space,
    .standard = standard_model<NacreModel>,
    .options = kNacreOptions};

std::string NacreModel::text() const {
    return fmt::format("specimen={} hot_spot={}", specimen, hot_spot);
}

std::shared_ptr<const Bsdf> NacreModel::make(const ModelInput& input,
                                             const Progress& progress) const {
    return std::make_shared<const Nacre>(input.solved, *this, progress);
}

}  // namespace nacre::bsdf
