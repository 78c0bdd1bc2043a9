#pragma once

#include <span>
#include <string_view>

// The appearance models that Nacre offers, as data: what they are called, what they take and what
// they can show. make_surface.h builds them.

namespace nacre::models {

enum class Model { microflake, thin_film, special_effect, nacre, walk, volume };

/// What a model can show: the columns of Table 3 of Mir et al. [mir-2022]. A test measures each.
struct Capabilities {
    bool goniochromism = false;        ///< colour that turns with angle
    bool sparkle = false;              ///< single flakes that flash
    bool multiple_scattering = false;  ///< between flakes and between layers
    bool reference_only = false;       ///< an unbiased simulation: no values, only pictures
};

/// Which part of a recipe a model reads.
enum class Ingredients { layers, microfacet };

struct ModelInfo {
    Model model;
    std::string_view name;     ///< on the command line
    std::string_view summary;  ///< in one line
    std::string_view source;   ///< authors and year
    Ingredients ingredients;
    Capabilities can;
};

std::span<const ModelInfo> all_models();
const ModelInfo& info(Model model);
/// Null if there is none of that name.
const ModelInfo* find_model(std::string_view name);

}  // namespace nacre::models
