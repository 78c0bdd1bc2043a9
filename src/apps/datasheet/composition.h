#pragma once

#include <string>
#include <vector>

#include "apps/report/report.h"
#include "nacre/fit/uncertainty.h"
#include "nacre/paint/recipe.h"

// What a paint is made of, for people.

namespace nacre::datasheet {

/// A shipped material as chemists write it, "TiO₂ (anatase)"; a number as "n = 1.58"; other names
/// as they are.
std::string material_text(const optics::Material& material);

/// One sentence for each coat, layer and the ground, from the top down.
std::vector<std::string> layers_in_words(const paint::Recipe& recipe);

/// The same as a table: a row for each flake, pigment, coat and the ground.
report::Table layers_table(const paint::Recipe& recipe);

/// The film on facets that the microfacet models take instead of layers.
std::vector<std::string> facets_in_words(const paint::Microfacet& microfacet);

/// Which numbers of the recipe are wrong together, and what a share of the variance is then.
std::string correlations_in_words(const fit::Uncertainty& uncertainty);

}  // namespace nacre::datasheet
