#include "nacre/montecarlo/discs/disc_walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <tuple>

#include "nacre/bsdf/models/nacre.h"
#include "nacre/core/error.h"
#include "nacre/core/random.h"
#include "nacre/montecarlo/discs/airy_disc.h"
#include "nacre/montecarlo/discs/disc_scene.h"
#include "nacre/montecarlo/events.h"
#include "nacre/montecarlo/plane_walk.h"
#include "nacre/paint/expansion.h"

namespace nacre::montecarlo {
namespace {

/// The smallest cosine to the normal, to which flatter rays, one in a million, are turned: they
/// then cross the tile ten million times at most (kMinTileFraction) before they leave a slab
/// without flakes.
constexpr double kGrazing = 1e-6;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

}  // namespace

std::optional<Escape> DiscWalker::run(double x_um, double y_um, const Vec3d& travel,
                                      const Lanes& weight) {
    position_ = {x_um, y_um, 0};
    paint_.discs.tile().wrap(position_.x, position_.y);
    moved_ = Vec3d{};
    start(travel, weight);
    leaving_ = DiscScene::kNone;
    slab_top_ = 0;
    escape_.reset();
    for (std::uint64_t flights = 0; state_.alive; ++flights) {
        count_flight(flights);
        fly();
    }
    return escape_;
}

/// To the next disc or pigment particle, or to the edge of the slab or of the tile, whichever comes
/// first.
void DiscWalker::fly() {
    if (std::abs(state_.travel.z) < kGrazing) {
        state_.travel.z = std::copysign(kGrazing, state_.travel.z);
        state_.travel = normalize(state_.travel);
    }
    const Slab& slab = this->slab();
    const bool down = state_.travel.z < 0;
    const double bottom = slab_top_ - slab.thickness_um;
    const double to_slab =
        std::max(0.0, ((down ? bottom : slab_top_) - position_.z) / state_.travel.z);
    const Tile& tile = paint_.discs.tile();
    const double to_edge = tile.to_edge(position_.x, position_.y, state_.travel.x, state_.travel.y);
    const double to_pigment =
        slab.pigment_rate_per_um > 0 ? random_.exponential() / slab.pigment_rate_per_um : kInfinity;
    double distance = std::min({to_slab, to_edge, to_pigment});
    const auto hit = paint_.discs.intersect(to_float(position_), to_float(state_.travel),
                                            static_cast<float>(distance), leaving_);
    if (hit) distance = hit->distance_um;
    position_ += distance * state_.travel;
    moved_ += distance * state_.travel;
    absorb(slab, distance);
    if (!state_.alive) return;
    if (hit) {
        position_.z = std::clamp(position_.z, bottom, slab_top_);
        collide_with_disc(hit->disc);
    } else if (to_slab <= std::min(to_edge, to_pigment)) {
        down ? descend() : ascend();
    } else if (to_edge <= to_pigment) {
        tile.step_over(position_.x, position_.y, state_.travel.x, state_.travel.y);
        leaving_ = DiscScene::kNone;
    } else {
        leaving_ = DiscScene::kNone;
        collide_with_pigment(slab);
    }
}

void DiscWalker::collide_with_disc(std::uint32_t number) {
    const Disc& disc = paint_.discs[number];
    leaving_ = number;
    const Vec3d plane = normalize(Vec3d{disc.normal.x, disc.normal.y, disc.normal.z});
    const Vec3d normal = surface_normal(plane, paint_.waviness[disc.species]);
    const double projection = dot(state_.travel, normal);
    const auto optics =
        paint_.films[disc.species].at(disc.film, std::abs(projection), paint_.places);
    const FlakeEvent event =
        collide_with_flake(optics.reflectance, optics.transmittance, projection, normal);
    if (event == FlakeEvent::absorbed) return;
    if (event == FlakeEvent::reflected && paint_.diffraction)
        state_.travel = spread(state_.travel, normal, 2.0 * disc.radius_um);
    roulette();
}

/// The normal of the piece of a wavy disc that light meets: slopes have Beckmann's law about the
/// plane, and count by their area across the light. Pieces that would mirror the light through the
/// disc are drawn anew: it would meet the disc's surface again.
Vec3d DiscWalker::surface_normal(const Vec3d& plane, double waviness) {
    if (waviness == 0) return plane;
    const Vec3d across = perpendicular(plane), along = cross(plane, across);
    const double facing = dot(state_.travel, plane);
    constexpr double kSteepest = 4;  // in waviness: 1e-7 are steeper
    const double bound = std::sqrt(1 + kSteepest * kSteepest * waviness * waviness);
    constexpr int kTrials = 256;
    for (int i = 0; i < kTrials; ++i) {
        const auto [radius, c, s] = random_.slope();
        if (radius > kSteepest) continue;
        const Vec3d piece = plane + (waviness * radius) * (c * across + s * along);
        const double projection = dot(state_.travel, piece);
        if (random_.uniform() * bound >= std::abs(projection)) continue;
        const Vec3d normal = normalize(piece);
        const double back = facing - 2 * dot(state_.travel, normal) * dot(normal, plane);
        if (back * facing < 0) return normal;
    }
    return plane;  // at grazing incidence
}

/// The specular direction, spread by diffraction. Directions beyond the disc's horizon are drawn
/// anew: 0.4 % at normal incidence on a flake of 20 um.
Vec3d DiscWalker::spread(const Vec3d& specular, const Vec3d& normal, double diameter_um) {
    const double scale = paint_.wavelength_um / (index_ * std::numbers::pi * diameter_um);
    const double upright = dot(specular, normal);
    const Vec3d flat = specular - upright * normal;
    const Vec3d across = perpendicular(normal);
    // Flakes as small as the wavelength have most of their pattern beyond the horizon: after so
    // many trials the specular direction is taken.
    constexpr int kTrials = 64;
    for (int i = 0; i < kTrials; ++i) {
        const auto [fraction, turn] = random_.pair();
        const double q = scale * AiryDisc::radius_of_fraction(fraction);
        const double phi = 2 * std::numbers::pi * turn;
        const Vec3d tangential =
            flat + q * (std::cos(phi) * across + std::sin(phi) * cross(normal, across));
        const double rest = 1 - dot(tangential, tangential);
        if (rest > 0)
            return normalize(tangential + std::copysign(std::sqrt(rest), upright) * normal);
    }
    return specular;
}

void DiscWalker::descend() {
    position_.z = slab_top_ - slab().thickness_um;
    if (state_.slab + 1 < medium_.slabs.size()) {
        slab_top_ = position_.z;
        ++state_.slab;
        return;
    }
    if (!reflect_off_substrate()) return;
    leaving_ = DiscScene::kNone;
    state_.travel = sample_lambert(random_);
    roulette();
}

void DiscWalker::ascend() {
    position_.z = slab_top_;
    if (state_.slab > 0) {
        --state_.slab;
        slab_top_ += slab().thickness_um;
        return;
    }
    leaving_ = DiscScene::kNone;
    const auto passage = interface_.sample_from_inside(state_.travel, random_);
    state_.travel = passage.travel;
    if (passage.inside) return;
    state_.alive = false;
    moved_.z = 0;
    escape_ = Escape{state_.travel, moved_, state_.weight};
}

namespace {

constexpr double kUmPerMm = 1e3;

/// The recipe without flakes, which are discs of the scene.
paint::Recipe without_flakes(paint::Recipe recipe) {
    for (paint::Layer& layer : recipe.layers) layer.flakes.clear();
    return recipe;
}

std::vector<DiscFilms> make_films(const paint::Recipe& recipe,
                                  const std::vector<double>& wavelengths_nm, std::uint64_t seed,
                                  SharedProgress& work) {
    std::vector<DiscFilms> films;
    for (const paint::Layer& layer : recipe.layers) {
        for (const paint::FlakeSpecies& species : layer.flakes) {
            films.emplace_back(species, recipe.binder, wavelengths_nm, hash_of(seed, films.size()),
                               &work);
        }
    }
    return films;
}

std::vector<int> counts(const std::vector<DiscFilms>& films) {
    std::vector<int> result;
    for (const DiscFilms& f : films) result.push_back(f.count());
    return result;
}

Tile checked_tile(const ExplicitFlakesModel& settings, const paint::Recipe& recipe) {
    const auto side_um = [](double side_mm, const char* name) {
        if (!kTileSide.contains(side_mm))
            throw DomainError(
                fmt::format("{} = {} is outside {}", name, side_mm, kTileSide.text()));
        return kUmPerMm * side_mm;
    };
    const Tile tile{side_um(settings.tile_width_mm, "tile_width_mm"),
                    side_um(settings.tile_height_mm, "tile_height_mm")};
    const double min_side_um = kMinTileFraction * recipe.thickness_um();
    if (std::min(tile.width_um, tile.height_um) < min_side_um) {
        throw DomainError(fmt::format(
            "a tile of {} mm x {} mm is too narrow for a paint of {} um: each side must be at "
            "least {} mm",
            settings.tile_width_mm, settings.tile_height_mm, recipe.thickness_um(),
            min_side_um / kUmPerMm));
    }
    return tile;
}

/// The rotation from the frame in which a renderer tells directions to that of the tile.
class TileFrame {
 public:
    explicit TileFrame(const sparkle::ObjectSpaceFootprint& patch)
        : x_(patch.tangent),
          y_(cross(patch.normal, patch.tangent)),
          // Seen from behind, the panel is turned over about its x axis.
          behind_(patch.normal.z < 0) {}

    Vec3d to_tile(const Vec3d& v) const {
        const Vec3d turned{v.x * x_.x + v.y * y_.x, v.x * x_.y + v.y * y_.y, v.z};
        return behind_ ? Vec3d{turned.x, -turned.y, turned.z} : turned;
    }
    Vec3d to_local(const Vec3d& v) const {
        const double y = behind_ ? -v.y : v.y;
        return {v.x * x_.x + y * x_.y, v.x * y_.x + y * y_.y, v.z};
    }
    double place_y(const Vec3f& position_mm) const {
        return behind_ ? -position_mm.y : position_mm.y;
    }

 private:
    Vec3f x_, y_;
    bool behind_;
};

}  // namespace

struct DiscWalkTables {
    WalkTables medium;
    std::vector<double> wavelengths_nm;
    std::vector<DiscFilms> films;
    DiscScene scene;
    bool diffraction;
    bool leans;
    std::vector<double> waviness;

    /// @param recipe  expanded
    DiscWalkTables(const paint::Recipe& recipe, const Tile& tile,
                   const ExplicitFlakesModel& settings, const std::vector<double>& grid_nm,
                   SharedProgress& work)
        : medium(without_flakes(recipe), grid_nm, {}),
          wavelengths_nm(grid_nm),
          films(make_films(recipe, grid_nm, settings.specimen, work)),
          scene(draw_discs(recipe, tile, counts(films), settings.specimen, &work), tile, &work),
          diffraction(settings.diffraction),
          leans(recipe.flake_lean().has_value()) {
        for (const paint::Layer& layer : recipe.layers) {
            for (const paint::FlakeSpecies& species : layer.flakes) {
                waviness.push_back(species.waviness);
            }
        }
    }
};

namespace {

class BoundDiscWalk final : public BoundWalk {
 public:
    BoundDiscWalk(std::shared_ptr<const DiscWalkTables> tables,
                  const bsdf::Wavelengths& wavelengths_nm)
        : BoundWalk(tables->medium, wavelengths_nm),
          tables_(std::move(tables)),
          paint_{tables_->scene,
                 tables_->films,
                 medium(),
                 bsdf::locate_wavelengths(tables_->wavelengths_nm, wavelengths_nm),
                 tables_->diffraction,
                 1e-3 * std::accumulate(wavelengths_nm.begin(), wavelengths_nm.end(), 0.0) / kLanes,
                 tables_->waviness} {
        estimate_typical_weight();
    }

 private:
    std::optional<Escape> follow(const Entry& entry, RandomStream& random) const override {
        DiscWalker walker(paint_, interface(entry.lane), index(entry.lane), random);
        if (!entry.patch) {
            const Tile& tile = tables_->scene.tile();
            const double x = tile.width_um * random.uniform();
            const double y = tile.height_um * random.uniform();
            return walker.run(x, y, entry.travel, entry.weight);
        }
        const sparkle::ObjectSpaceFootprint& patch = entry.patch->footprint;
        const TileFrame frame(patch);
        auto escape =
            walker.run(kUmPerMm * patch.position_mm.x, kUmPerMm * frame.place_y(patch.position_mm),
                       frame.to_tile(entry.travel), entry.weight);
        if (escape) {
            escape->direction = frame.to_local(escape->direction);
            escape->position_um = frame.to_local(escape->position_um);
        }
        return escape;
    }

    std::shared_ptr<const DiscWalkTables> tables_;
    DiscPaint paint_;
};

}  // namespace

DiscWalk::DiscWalk(const paint::Recipe& recipe, const ExplicitFlakesModel& settings,
                   const std::vector<double>& wavelengths_nm, const Progress& progress) {
    paint::validate(recipe, wavelengths_nm);
    const Tile tile = checked_tile(settings, recipe);
    require_discs(recipe, tile);
    SharedProgress work(progress, 1);
    work.add(0);
    tables_ = std::make_shared<const DiscWalkTables>(paint::expanded(recipe), tile, settings,
                                                     wavelengths_nm, work);
}

DiscWalk::~DiscWalk() = default;

std::unique_ptr<const bsdf::BoundBsdf> DiscWalk::bind(
    const bsdf::Wavelengths& wavelengths_nm) const {
    return std::make_unique<BoundDiscWalk>(tables_, wavelengths_nm);
}

bool DiscWalk::leans_by_itself() const { return tables_->leans; }

const DiscScene& DiscWalk::scene() const { return tables_->scene; }

namespace {

constexpr bsdf::Alternative kInPlaceOfHashedFlakes{
    .to = &bsdf::NacreModel::info,
    .flag = "--flakes",
    .help =
        "nacre: hashed (statistics, on any shape), or explicit (the ground truth: every flake "
        "a disc, under flat panels)",
    .usual = "hashed",
    .value = "explicit",
    .from = [](const bsdf::Model& other) -> bsdf::Model {
        const bsdf::NacreModel& nacre = *other.get<bsdf::NacreModel>();
        if (!nacre.hot_spot) {
            throw DomainError(
                "--no-hot-spot is for hashed flakes: explicit ones have a hot spot by themselves");
        }
        return ExplicitFlakesModel{.specimen = nacre.specimen};
    }};

}  // namespace

constinit const bsdf::ModelInfo ExplicitFlakesModel::info = {
    .name = bsdf::NacreModel::kName,
    .summary = "every flake a disc, light followed from disc to disc",
    .source = "this project",
    .ingredients = bsdf::Ingredients::layers,
    .solution = bsdf::Solution::none,
    .can = {.goniochromism = true,
            .sparkle = true,
            .multiple_scattering = true,
            .reference_only = true},
    .coordinates = bsdf::SurfaceCoordinates::object_space,
    .standard = bsdf::standard_model<ExplicitFlakesModel>,
    .alternative = &kInPlaceOfHashedFlakes};

std::string ExplicitFlakesModel::text() const {
    return fmt::format("flakes={} tile_width_mm={} tile_height_mm={} specimen={} diffraction={}",
                       kInPlaceOfHashedFlakes.value, tile_width_mm, tile_height_mm, specimen,
                       diffraction);
}

std::shared_ptr<const bsdf::Bsdf> ExplicitFlakesModel::make(const bsdf::ModelInput& input,
                                                            const Progress& progress) const {
    return std::make_shared<const DiscWalk>(input.recipe, *this, spectra::default_wavelengths_nm(),
                                            progress);
}

void ExplicitFlakesModel::lie_on(const std::string& material,
                                 std::span<const bsdf::PaintedShape> shapes) {
    std::optional<std::pair<double, double>> common;
    for (const bsdf::PaintedShape& shape : shapes) {
        if (shape.kind != bsdf::PaintedShape::Kind::panel) {
            throw DomainError(
                fmt::format("the material {} is on a shape that is no flat panel; --flakes hashed "
                            "goes on any shape",
                            material));
        }
        const std::pair size{shape.width_mm, shape.height_mm};
        if (common && *common != size) {
            throw DomainError(
                fmt::format("the material {} is on panels of different sizes", material));
        }
        common = size;
    }
    // On no shape at all: any size will do.
    std::tie(tile_width_mm, tile_height_mm) = common.value_or(std::pair{1.0, 1.0});
}

}  // namespace nacre::montecarlo
