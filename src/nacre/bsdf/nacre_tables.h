#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "nacre/bsdf/flake_films.h"
#include "nacre/bsdf/microflake_tables.h"
#include "nacre/bsdf/nacre.h"
#include "nacre/bsdf/nacre_hot_spot.h"
#include "nacre/sparkle/flake_field.h"

// What the nacre model works out once a paint.

namespace nacre::bsdf {

/// One kind of flakes in one layer.
struct NacreSpecies {
    sparkle::FlakeField field;
    std::optional<FlakeFilms> films;  ///< empty: all alike
    /// Share of all singly scattered light that it sends back, seen from above, roughly: how often
    /// its flakes are sampled. The shares add up to 1.
    float share;
};

struct Nacre::Tables {
    Tables(std::shared_ptr<const layers::SolvedPaint> paint, std::uint64_t seed,
           const NacreSettings& settings);

    std::shared_ptr<Microflake::Tables> smooth;
    std::vector<NacreSpecies> species;       ///< layer by layer
    std::vector<std::size_t> first_species;  ///< of each layer
    std::optional<HotSpotTables> hot_spot;
};

}  // namespace nacre::bsdf
