#pragma once

#include <string>

#include "apps/studio/messages/recipe_tree.h"
#include "nacre/core/progress.h"

// What a page must know to offer a recipe's keys and what ships with Nacre: GET /api/schema. Its
// fields: docs/studio-api.md.

namespace nacre::studio {

/// Of the messages and addresses: rises when one that was there changes.
inline constexpr int kApiVersion = 1;

/// The tables of a recipe and their keys, from the one description of them
/// (paint/recipe_description.h).
Tree recipe_schema();

/// All of the schema. Takes a moment: pigments are solved for their colours.
/// @throws Stopped; Error where what ships cannot be read
Tree schema(const Progress& progress = {});

}  // namespace nacre::studio
