#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "nacre/bsdf/bsdf.h"
#include "nacre/layers/recipe.h"
#include "nacre/layers/solved_paint.h"

namespace nacre::study {

/// How the flakes of a paint are shown.
enum class Way {
    discs,     ///< explicit: each in its place, light traced among them
    mirrors,   ///< the same without diffraction
    hashed,    ///< the model `nacre`
    hot_spot,  ///< the same with its hot spot
    smooth     ///< their mean: `microflake`
};

/// In file names and results.
std::string name(Way way);

/// A recipe, and the surfaces that are made of it.
class FlakePaint {
 public:
    /// @param file  beside each other in studies/flakes; without its ending it names pictures
    explicit FlakePaint(const std::string& file, std::uint64_t seed);

    const std::string& key() const { return key_; }
    const layers::Recipe& recipe() const { return recipe_; }
    const layers::FlakeSpecies& species() const { return recipe_.layers[0].flakes[0]; }
    /// c H: flakes that a vertical line meets on average.
    double depth() const;
    double flakes_per_mm2() const;

    /// @param side_mm  of the panel: explicit flakes are laid out over all of it, others on each
    ///                 size of panel
    std::shared_ptr<const bsdf::Bsdf> surface(Way way, double side_mm);

    /// All that decides what surface() is.
    std::string identity(Way way, double side_mm) const;

 private:
    std::string key_;
    std::uint64_t seed_;
    layers::Recipe recipe_;
    std::shared_ptr<const layers::SolvedPaint> solved_;
    std::shared_ptr<const bsdf::Bsdf> hashed_, hot_spot_, smooth_;
};

}  // namespace nacre::study
