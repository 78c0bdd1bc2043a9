#include "nacre/bsdf/models/nacre.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "nacre/bsdf/models/rough_hot_spot.h"
#include "nacre/core/lane_math.h"
#include "nacre/core/random.h"
#include "nacre/paint/expansion.h"

namespace nacre::bsdf {
namespace {

sparkle::FlakePopulation population_of(const paint::FlakeSpecies& species,
                                       const paint::Layer& layer, double ior,
                                       double coat_roughness) {
    sparkle::FlakePopulation out;
    out.diameter_um = species.diameter_um;
    out.diameter_spread_um = species.diameter_spread_um;
    out.sizes = species.part;
    out.alpha = species.orientation.beckmann_alpha;
    out.waviness = species.waviness;
    out.ior = ior;
    out.coat_roughness = coat_roughness;
    constexpr double kSquareUmPerMm2 = 1e6;
    const double area_um2 = species.sizes().mean_area_um2();
    out.density_per_mm2 =
        species.area_density_per_um() * layer.thickness_um / area_um2 * kSquareUmPerMm2;
    return out;
}

// A lamp meets the lobe of diffraction or does not, which is the flake's own contrast. Of a lobe that
// waviness or a rough coat widens it lights a part, and one direction would tell as little of it as the
// toss of a coin: as many are drawn as the lobe is larger in area, up to a bound.
int directions_per_flake(const sparkle::FlakeField& field) {
    constexpr float kMax = NacreSpecies::kMaxDirections;
    const sparkle::DiffractionLobe& lobe = field.lobe();
    const auto radius = static_cast<float>(lobe.radius(field.population().diameter_um));
    const float wider = lobe.spread_radius2(lobe.spread2(lobe.coat().spread2(1.0f, 1.0f)));
    return static_cast<int>(std::min(1 + wider / (radius * radius), kMax));
}

// cos(w_i.h) of any two directions that the interface lets through, each within the critical angle.
double min_half_cosine(double ior) { return std::sqrt(std::max(0.0, 1 - 1 / (ior * ior))); }

}  // namespace

// Single scattering of each species at normal incidence, summed over the wavelengths; orientation is
// neglected.
std::vector<float> flake_fractions(const Microflake::Tables& tables) {
    const solver::PaintMedium& medium = tables.paint->medium;
    const int count = medium.wavelength_count();
    std::vector<double> returned;
    std::vector<double> depth(count, 0.0);
    for (std::size_t l = 0; l < medium.layers.size(); ++l) {
        const solver::LayerMedium& layer = medium.layers[l];
        std::vector<double> seen(count);  // thickness weighted by the attenuation both ways, um
        for (int w = 0; w < count; ++w) {
            const double here = 2 * tables.extinction[l][w] * layer.thickness_um;
            seen[w] = layer.thickness_um * std::exp(-depth[w]) * mean_attenuation(here);
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
    const double all = std::accumulate(returned.begin(), returned.end(), 0.0);
    std::vector<float> fractions;
    for (const double r : returned) fractions.push_back(static_cast<float>(r / all));
    return fractions;
}

std::vector<sparkle::FlakeField> flake_fields(const Microflake::Tables& tables,
                                              std::uint64_t specimen) {
    const paint::Recipe recipe = paint::expanded(tables.paint->recipe);
    const double coat_roughness = tables.rough ? tables.paint->medium.roughness : 0;
    std::vector<sparkle::FlakeField> fields;
    for (std::size_t l = 0; l < recipe.layers.size(); ++l) {
        const paint::Layer& layer = recipe.layers[l];
        for (std::size_t f = 0; f < layer.flakes.size(); ++f) {
            fields.emplace_back(
                population_of(layer.flakes[f], layer, tables.mean_ior, coat_roughness),
                hash_of(specimen, l, f));
        }
    }
    return fields;
}

SpeciesFilms species_films(const solver::SolvedPaint& paint, const FlakeFilmGrid& grid,
                           SharedProgress* work) {
    const paint::Recipe recipe = paint::expanded(paint.recipe);
    SpeciesFilms all;
    std::vector<const paint::FlakeSpecies*> known;
    for (const paint::Layer& layer : recipe.layers) {
        for (const paint::FlakeSpecies& flake : layer.flakes) {
            std::shared_ptr<const FlakeFilms> films;
            if (const auto* platelet = std::get_if<optics::Platelet>(&flake.body);
                platelet && FlakeFilms::vary(*platelet)) {
                const auto same = std::find_if(known.begin(), known.end(), [&](const auto* other) {
                    return other->body == flake.body;
                });
                films = same != known.end()
                            ? all[static_cast<std::size_t>(same - known.begin())]
                            : flake_films(*platelet, recipe.binder, grid.wavelengths_nm,
                                          min_half_cosine(mean_ior(paint.medium)), work,
                                          grid.cosine_intervals);
                if (films && films->alike()) films = nullptr;
            }
            known.push_back(&flake);
            all.push_back(std::move(films));
        }
    }
    return all;
}

std::vector<NacreSpecies> nacre_species(const Microflake::Tables& tables, std::uint64_t specimen,
                                        const SpeciesFilms& films) {
    const std::vector<float> fractions = flake_fractions(tables);
    std::vector<sparkle::FlakeField> fields = flake_fields(tables, specimen);
    std::vector<NacreSpecies> species;
    for (std::size_t s = 0; s < fields.size(); ++s) {
        const int directions = directions_per_flake(fields[s]);
        species.push_back({std::move(fields[s]), films[s], fractions[s], directions});
    }
    return species;
}

Nacre::Tables::Tables(std::shared_ptr<const solver::SolvedPaint> paint, const NacreModel& settings,
                      Wanted wanted, SharedProgress& work)
    : hot_spot(settings.hot_spot ? std::optional(HotSpotTables(*paint)) : std::nullopt),
      smooth(hot_spot ? std::make_shared<Microflake::Tables>(with_rough_hot_spot(paint, *hot_spot),
                                                             hot_spot->extinction())
                      : std::make_shared<Microflake::Tables>(paint)) {
    std::size_t before = 0;
    for (const solver::LayerMedium& layer : paint->medium.layers) {
        first_species.push_back(before);
        before += layer.flakes.size();
    }
    species = nacre_species(*smooth, settings.specimen,
                            wanted == Wanted::mean
                                ? SpeciesFilms(before)
                                : species_films(*paint, {paint->wavelengths_nm()}, &work));
    if (paint->recipe.flake_lean()) smooth->leaning.emplace(*paint, work);
    if (paint->recipe.coat_spread() > 0) {
        const CoatSpread& spread = smooth->coat_spread.emplace(*paint, settings.hot_spot, work);
        if (settings.hot_spot && !smooth->rough) {
            for (const solver::SolvedPaint& node : spread.paint) hot_spot_nodes.emplace_back(node);
        }
    }
}

Nacre::Nacre(std::shared_ptr<const solver::SolvedPaint> paint, const NacreModel& settings,
             const Progress& progress)
    : Nacre(std::move(paint), settings, progress, Wanted::all) {}

Nacre::Nacre(std::shared_ptr<const solver::SolvedPaint> paint, const NacreModel& settings,
             const Progress& progress, Wanted wanted)
    : waves_(bsdf::coat_waves(*paint, settings.specimen)),
      thickness_(bsdf::coat_thickness(*paint, settings.specimen)),
      lean_(bsdf::flake_lean(*paint)) {
    SharedProgress work(progress, 1);
    work.add(0);
    auto tables = std::make_shared<Tables>(std::move(paint), settings, wanted, work);
    // Flakes that lean are seen with their densities (LeaningFlakes).
    if (wanted == Wanted::all || lean_) {
        tabulate_sampling(*tables->smooth, [&](const Wavelengths& wavelengths_nm) {
            return std::make_unique<const BoundNacre>(tables, wavelengths_nm);
        });
    }
    tables_ = std::move(tables);
}

std::shared_ptr<const Nacre> Nacre::mean_alone(std::shared_ptr<const solver::SolvedPaint> paint,
                                               const NacreModel& settings,
                                               const Progress& progress) {
    return std::shared_ptr<const Nacre>(
        new Nacre(std::move(paint), settings, progress, Wanted::mean));
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

// The hot spot leaves less to be scattered again, by another fraction at each thickness.
CoatChange BoundNacre::coat_change(Vec3f wi, Vec3f wo, float deviation) const {
    const Ray i = make_ray(wi), o = make_ray(wo);
    CoatNodes table = coat_nodes(i, o);
    if (!hot_spot_nodes_.empty()) {
        const auto compensated = [&](const HotSpot& hot_spot, const FloatLanes& multiple) {
            const HotSpot::Pair pair(hot_spot, i, o);
            return pair.compensation() * max_lanes(multiple - pair.ground(), FloatLanes{});
        };
        table = {compensated(*hot_spot_, table.mean),
                 compensated(hot_spot_nodes_[0], table.thinner),
                 compensated(hot_spot_nodes_[1], table.thicker)};
    }
    return BoundMicroflake::coat_change(i, o, deviation, table);
}

namespace {

constexpr ModelOption kNacreOptions[] = {OptionFor<&NacreModel::hot_spot>::toggle(
    "--hot-spot",
    "nacre: light that came in between large flakes finds the same gaps on its way out (the "
    "default); without, the mean is that of microflake")};

}  // namespace

constinit const ModelInfo NacreModel::info = {
    .name = NacreModel::kName,
    .summary =
        "single flakes in layers: their light one by one, the rest solved by radiative "
        "transfer",
    .source = "this project",
    .ingredients = Ingredients::layers,
    .solution = Solution::solved,
    .can = {.goniochromism = true, .sparkle = true, .multiple_scattering = true, .fitted = true},
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

std::shared_ptr<const Bsdf> NacreModel::make_mean(std::shared_ptr<const solver::SolvedPaint> paint,
                                                  const Progress& progress) const {
    return Nacre::mean_alone(std::move(paint), *this, progress);
}

}  // namespace nacre::bsdf
