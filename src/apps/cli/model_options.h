#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "nacre/models/models.h"

namespace CLI {
class App;
}

// --model, and the options of all models, as their entries describe them (nacre/bsdf/model.h).

namespace nacre::cli {

struct ModelOptions {
    std::string model{models::default_model().info().name};
    bool model_given = false;    ///< --model was on the command line
    std::uint64_t specimen = 0;  ///< which panel of the batch a model of single flakes shows

    /// What the command line writes to.
    struct Value {
        std::string name;
        int number = 0;
        bool on = false;
    };
    std::map<std::string, Value> values = {};  ///< by flag; none before options were added
};

void add_model_options(CLI::App& command, ModelOptions& options);
/// Only those that say how a solution is kept, for `solve`.
void add_solution_options(CLI::App& command, ModelOptions& options);

/// @throws UsageError naming the model and those that exist
const bsdf::ModelInfo& parse_model(const ModelOptions& options);

/// The model with all that was chosen about it.
/// @throws UsageError if a choice was made that the model does not know
bsdf::Model parse_model_settings(const ModelOptions& options);

/// The same if --model, or any option of a model but --specimen, was given; none leaves the choice to
/// what is done with the paint.
/// @throws UsageError as parse_model_settings()
std::optional<bsdf::Model> chosen_model(const ModelOptions& options);

/// What the command line said to choose this model, as in "--model = volume".
std::string choice_of(const bsdf::ModelInfo& model);

/// The options of models that say in which form a solution is kept.
std::vector<std::string> solution_flags();
/// Without --model, chooses the model that has such an option where one was given another value than its
/// default.
void choose_by_table(ModelOptions& options);
/// What the command line said about models, as in "--no-hot-spot"; none if it said nothing.
std::optional<std::string> choice_of_any(const ModelOptions& options);
/// What the command line said to have a model make a table, as in "--table = svd".
std::string choice_of_table(const bsdf::Model& model);

/// The names of all models that satisfy a condition.
std::vector<std::string> models_that(bool (*condition)(const bsdf::ModelInfo&));
/// Those that show single flakes, the one that shows most first.
std::vector<std::string> sparkling_models();

/// What something means, for help: to the models whose surfaces vary by the millimetres of object
/// space, and to those whose surfaces vary by shares of a unit square, as in "this: in mm; that:
/// as a share".
std::string by_coordinates(const std::string& in_object_space, const std::string& in_unit_square);
/// The models of the second kind.
std::vector<std::string> unit_square_models();

}  // namespace nacre::cli
