#include "nacre/study/flakes_paint.h"

#include <fmt/format.h>

#include <cmath>

#include "nacre/core/data_directory.h"
#include "nacre/core/rng.h"
#include "nacre/discs/disc_walk.h"
#include "nacre/io/recipe_file.h"
#include "nacre/layers/solver.h"
#include "nacre/models/make_surface.h"

namespace nacre::study {
namespace {

bool is_explicit(Way way) { return way == Way::discs || way == Way::mirrors; }

}  // namespace

std::string name(Way way) {
    switch (way) {
        case Way::discs:
            return "discs";
        case Way::mirrors:
            return "mirrors";
        case Way::hashed:
            return "hashed";
        case Way::hot_spot:
            return "hot-spot";
        case Way::smooth:
            return "smooth";
    }
    return "";
}

FlakePaint::FlakePaint(const std::string& file, std::uint64_t seed)
    : key_(file.substr(0, file.find('.'))),
      seed_(seed),
      recipe_(io::read_recipe(shipped_file("studies/flakes/" + file))) {}

double FlakePaint::depth() const {
    return species().area_density_per_um() * recipe_.layers[0].thickness_um;
}

double FlakePaint::flakes_per_mm2() const {
    constexpr double kUmPerMm = 1e3;
    return discs::expected_discs(recipe_, {kUmPerMm, kUmPerMm});
}

std::shared_ptr<const bsdf::Bsdf> FlakePaint::surface(Way way, double side_mm) {
    if (is_explicit(way)) {
        // With one seed the same arrangement would appear at every size, larger or smaller.
        const auto seed = hash_of(seed_, std::llround(1e6 * side_mm));
        return std::make_shared<const discs::DiscWalk>(
            recipe_, discs::DiscSettings{side_mm, side_mm, seed, way == Way::discs});
    }
    if (!solved_) {
        solved_ = std::make_shared<const layers::SolvedPaint>(
            layers::solve(recipe_, layers::default_wavelengths_nm(), {}));
    }
    auto& made = way == Way::hashed ? hashed_ : way == Way::hot_spot ? hot_spot_ : smooth_;
    if (!made) {
        models::SurfaceOptions options;
        options.seed = seed_;
        options.hot_spot = way == Way::hot_spot;
        const models::Paint paint{.recipe = recipe_, .solved = solved_, .table = {}};
        made = models::make_surface(
            way == Way::smooth ? models::Model::microflake : models::Model::nacre, paint, options);
    }
    return made;
}

std::string FlakePaint::identity(Way way, double side_mm) const {
    return fmt::format("{} {} seed {} side {}", io::recipe_hash(recipe_), name(way), seed_,
                       is_explicit(way) ? side_mm : 0);
}

}  // namespace nacre::study
