#include "nacre/volume/shell_walk.h"

#include <fmt/format.h>

#include <cmath>

#include "nacre/core/error.h"
#include "nacre/volume/shell_walker.h"

namespace nacre::volume {
namespace {

constexpr double kUmPerMm = 1e3;

class BoundShellWalk final : public BoundWalk {
 public:
    BoundShellWalk(std::shared_ptr<const WalkTables> tables, const ShellSettings& settings,
                   const bsdf::Wavelengths& wavelengths_nm)
        : BoundWalk(*tables, wavelengths_nm),
          settings_(settings),
          curvature_per_um_(1 / (kUmPerMm * settings.radius_mm)) {
        weigh_mirror();
    }

 private:
    std::optional<Escape> follow(const Entry& entry, RandomStream& random) const override {
        return ShellWalker(medium(), index(entry.lane), curvature_per_um_, settings_, random)
            .run(entry.travel, entry.weight);
    }

    ShellSettings settings_;
    double curvature_per_um_;
};

void check(const layers::Recipe& recipe, const ShellSettings& settings) {
    if (!kShellRadius.contains(settings.radius_mm)) {
        throw DomainError(
            fmt::format("radius_mm = {} is outside {}", settings.radius_mm, kShellRadius.text()));
    }
    if (!kSimpsonPanels.contains(settings.simpson_panels)) {
        throw DomainError(fmt::format("simpson_panels = {} is outside {}", settings.simpson_panels,
                                      kSimpsonPanels.text()));
    }
    if (recipe.clearcoat && recipe.clearcoat->roughness > 0) {
        throw DomainError(
            fmt::format("clearcoat.roughness = {}: the walk through a shell knows smooth "
                        "interfaces only; the position-free walk knows rough ones",
                        recipe.clearcoat->roughness));
    }
    double thickness_um = recipe.clearcoat ? recipe.clearcoat->thickness_um : 0;
    for (const layers::Layer& layer : recipe.layers) thickness_um += layer.thickness_um;
    // Something must be left for the paint to lie on: a millionth of the radius keeps its digits.
    constexpr double kLargestShare = 1 - 1e-6;
    if (!(thickness_um < kLargestShare * kUmPerMm * settings.radius_mm)) {
        throw DomainError(fmt::format("a paint of {} um does not fit on a sphere of radius {} mm",
                                      thickness_um, settings.radius_mm));
    }
}

}  // namespace

ShellWalk::ShellWalk(const layers::Recipe& recipe, const ShellSettings& settings,
                     const std::vector<double>& wavelengths_nm)
    : tables_(std::make_shared<const WalkTables>(recipe, wavelengths_nm)), settings_(settings) {
    check(recipe, settings);
}

ShellWalk::~ShellWalk() = default;

std::unique_ptr<const bsdf::BoundBsdf> ShellWalk::bind(
    const bsdf::Wavelengths& wavelengths_nm) const {
    return std::make_unique<BoundShellWalk>(tables_, settings_, wavelengths_nm);
}

}  // namespace nacre::volume
