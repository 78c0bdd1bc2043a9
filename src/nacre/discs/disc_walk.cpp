#include "nacre/discs/disc_walk.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

#include "nacre/core/error.h"
#include "nacre/discs/disc_scene.h"
#include "nacre/discs/disc_walker.h"
#include "nacre/volume/bound_walk.h"

namespace nacre::discs {
namespace {

constexpr double kUmPerMm = 1e3;

/// The recipe with nothing between its pigments: flakes stand elsewhere, as discs.
layers::Recipe without_flakes(layers::Recipe recipe) {
    for (layers::Layer& layer : recipe.layers) layer.flakes.clear();
    return recipe;
}

std::vector<FlakeFilms> make_films(const layers::Recipe& recipe,
                                   const std::vector<double>& wavelengths_nm, std::uint64_t seed) {
    std::vector<FlakeFilms> films;
    for (const layers::Layer& layer : recipe.layers) {
        for (const layers::FlakeSpecies& species : layer.flakes) {
            films.emplace_back(species, recipe.binder, wavelengths_nm, hash_of(seed, films.size()));
        }
    }
    return films;
}

std::vector<int> counts(const std::vector<FlakeFilms>& films) {
    std::vector<int> result;
    for (const FlakeFilms& f : films) result.push_back(f.count());
    return result;
}

Tile checked_tile(const DiscSettings& settings, const layers::Recipe& recipe) {
    const auto side_um = [](double side_mm, const char* name) {
        if (!kTileSide.contains(side_mm))
            throw DomainError(
                fmt::format("{} = {} is outside {}", name, side_mm, kTileSide.text()));
        return kUmPerMm * side_mm;
    };
    const Tile tile{side_um(settings.tile_width_mm, "tile_width_mm"),
                    side_um(settings.tile_height_mm, "tile_height_mm")};
    const double least = kLeastTileShare * paint_thickness_um(recipe);
    if (std::min(tile.width_um, tile.height_um) < least) {
        throw DomainError(fmt::format(
            "a tile of {} mm x {} mm is too narrow for a paint of {} um: each side must be at "
            "least {} mm",
            settings.tile_width_mm, settings.tile_height_mm, paint_thickness_um(recipe),
            least / kUmPerMm));
    }
    return tile;
}

/// The rotation from the frame in which a renderer tells directions to that of the tile.
class TileFrame {
 public:
    explicit TileFrame(const sparkle::RestPatch& patch)
        : x_(patch.tangent),
          y_(cross(patch.normal, patch.tangent)),
          // Seen from behind, the panel is turned over about its x axis.
          behind_(patch.normal.z < 0) {}

    Direction3 to_tile(const Direction3& v) const {
        const Direction3 turned(v.x() * x_.x + v.y() * y_.x, v.x() * x_.y + v.y() * y_.y, v.z());
        return behind_ ? Direction3(turned.x(), -turned.y(), turned.z()) : turned;
    }
    Direction3 to_local(const Direction3& v) const {
        const double y = behind_ ? -v.y() : v.y();
        return {v.x() * x_.x + y * x_.y, v.x() * y_.x + y * y_.y, v.z()};
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
    volume::WalkTables medium;
    std::vector<double> wavelengths_nm;
    std::vector<FlakeFilms> films;
    DiscScene scene;
    bool diffraction;

    DiscWalkTables(const layers::Recipe& recipe, const Tile& tile, const DiscSettings& settings,
                   const std::vector<double>& grid_nm)
        : medium(without_flakes(recipe), grid_nm),
          wavelengths_nm(grid_nm),
          films(make_films(recipe, grid_nm, settings.seed)),
          scene(draw_discs(recipe, tile, counts(films), settings.seed), tile),
          diffraction(settings.diffraction) {}
};

namespace {

class BoundDiscWalk final : public volume::BoundWalk {
 public:
    BoundDiscWalk(std::shared_ptr<const DiscWalkTables> tables,
                  const bsdf::Wavelengths& wavelengths_nm)
        : BoundWalk(tables->medium, wavelengths_nm),
          tables_(std::move(tables)),
          paint_{
              tables_->scene,
              tables_->films,
              medium(),
              bsdf::locate_wavelengths(tables_->wavelengths_nm, wavelengths_nm),
              tables_->diffraction,
              1e-3 * std::accumulate(wavelengths_nm.begin(), wavelengths_nm.end(), 0.0) / kLanes} {
        weigh_mirror();
    }

 private:
    std::optional<volume::Escape> follow(const volume::Entry& entry,
                                         RandomStream& random) const override {
        DiscWalker walker(paint_, interface(entry.lane), index(entry.lane), random);
        if (!entry.patch) {
            const Tile& tile = tables_->scene.tile();
            const double x = tile.width_um * random.uniform();
            const double y = tile.height_um * random.uniform();
            return walker.run(x, y, entry.travel, entry.weight);
        }
        const sparkle::RestPatch& patch = entry.patch->rest;
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

DiscWalk::DiscWalk(const layers::Recipe& recipe, const DiscSettings& settings,
                   const std::vector<double>& wavelengths_nm) {
    layers::validate(recipe, wavelengths_nm);
    const Tile tile = checked_tile(settings, recipe);
    tables_ = std::make_shared<const DiscWalkTables>(recipe, tile, settings, wavelengths_nm);
    // Says now, not at the first picture, what is wrong with a rough interface.
    reference::make_air_interface(recipe, tables_->medium.grid.index(wavelengths_nm.front()));
}

DiscWalk::~DiscWalk() = default;

std::unique_ptr<const bsdf::BoundBsdf> DiscWalk::bind(
    const bsdf::Wavelengths& wavelengths_nm) const {
    return std::make_unique<BoundDiscWalk>(tables_, wavelengths_nm);
}

const DiscScene& DiscWalk::scene() const { return tables_->scene; }

}  // namespace nacre::discs
