#pragma once

#include "nacre/paint/recipe.h"

namespace nacre::testing {

/// One of everything that a recipe may have.
inline paint::Recipe full_recipe() {
    using namespace paint;
    Recipe recipe;
    recipe.binder = optics::Material(1.5);
    recipe.clearcoat = Clearcoat{40, spectra::Spectrum({400, 700}, {2.0, 8.0}), 0.1};
    FlakeSpecies pearl;
    pearl.amount = VolumeFraction{0.05};
    pearl.body =
        optics::Platelet{{optics::Material(1.58), 500, {30}}, {{optics::Material(2.5), 80, {5}}}};
    FlakeSpecies mirror;
    mirror.amount = AreaDensity{0.1};
    mirror.body = PrescribedFlake{0.6, 0.2, 0.3};
    recipe.layers = {{15, {pearl, mirror}, {{20.0, 5.0, 0.3}}}, {10, {}, {}}};
    recipe.substrate_reflectance = 0.2;
    recipe.microfacet = Microfacet{};
    recipe.microfacet->facets = MicrofacetFacets{1e6, 3, 10};
    return recipe;
}

}  // namespace nacre::testing
