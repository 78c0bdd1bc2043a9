#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "apps/studio/messages/recipe_tree.h"
#include "apps/studio/messages/stage.h"
#include "nacre/measure/geometry.h"
#include "nacre/measure/tolerance.h"
#include "nacre/spectra/observer.h"

// What a page asks for: text frames of the WebSocket, one JSON object each (docs/studio-api.md).

namespace nacre::studio {

/// The largest frame and the largest body of a request that is taken, in bytes.
inline constexpr std::size_t kMaxMessageBytes = 8u << 20;

/// The names of the models by which paints are read, the first where a message names none.
using ReadingModels = std::span<const std::string_view>;
/// The name as it is. @throws InputError with those that there are
std::string parse_reading_model(const std::string& name, ReadingModels models);

/// Light and eye by which colours are stated, the angles, and the model that reads paints.
struct Viewed {
    std::vector<measure::Geometry> geometries;
    spectra::Illuminant illuminant = spectra::Illuminant::D65;
    spectra::Observer observer = spectra::Observer::cie1964_10deg;
    std::string model = {};
};

/// A text of a recipe.
struct OpenRequest {
    std::string toml;
    std::string name = {};  ///< of its file in messages; empty: it has none
};
struct PaintRequest {
    Tree recipe;
    Viewed viewed;
    bool shader = false;
    spectra::Illuminant lamp = spectra::Illuminant::D65;  ///< in which the shader shows it
    measure::Tolerance tolerance = {};                    ///< against the standard
};
/// What tells single flakes of the shader's paint apart.
struct FilmsRequest {
    Tree recipe;
};
struct StandardRequest {
    std::optional<std::string> text;  ///< none: no standard any more
    std::string name, sample;
    std::string model = {};  ///< of a recipe
};
struct SparkleRequest {
    Tree recipe;
    double specimen = 0;
};
struct FitRequest {
    Tree recipe;
    std::vector<std::string> free;  ///< empty: those of the recipe's table [fit]
    int starts = 8;
    std::string model = {};  ///< by which paints are seen
};
/// Ends a fit, a picture or another long answer.
struct StopRequest {
    std::optional<std::string> type;  ///< of the request that is to stop; none: all that are long
};
struct RenderRequest {
    Tree recipe;
    Stage stage;
    int width = 512, height = 512, samples = 64;
    std::string model;  ///< any; empty: models::default_picture_model()
    bool linear = false;
};
struct ReportRequest {
    Tree recipe;
    Viewed viewed;
    measure::Tolerance tolerance = {};
    bool draft = false;  ///< small and noisy pictures
};

/// Colours by the values of one number.
struct AtlasRequest {
    Tree recipe;
    std::string key;  ///< "layer[0].flakes[0].coats[0].thickness_nm"
    std::vector<double> values;
    Viewed viewed;
};

/// A shape or a light from a file of the page's.
struct ShapeRequest {
    std::string file, bytes;
    bool y_up = false;
};
struct LightRequest {
    std::string file, bytes;
};

using Request = std::variant<OpenRequest, PaintRequest, FilmsRequest, StandardRequest,
                             SparkleRequest, FitRequest, StopRequest, RenderRequest, ReportRequest,
                             AtlasRequest, ShapeRequest, LightRequest>;

struct Message {
    Tree id;           ///< a number or a text, by which its answers are known
    std::string type;  ///< "paint"
    Request request;
};

/// What is wrong with a message, with as much of it as was understood.
class MessageError : public InputError {
 public:
    MessageError(const std::string& what, Tree id) : InputError(what), id_(std::move(id)) {}
    const Tree& id() const { return id_; }

 private:
    Tree id_;
};

/// @throws MessageError naming key, value and what is allowed
Message parse_message(std::string_view text, ReadingModels models);

}  // namespace nacre::studio
