#include "apps/studio/messages/reading_models.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/core/text.h"

namespace nacre::studio {

std::string parse_reading_model(const std::string& name) {
    std::vector<std::string> names;
    for (const ReadingModel& model : kReadingModels) names.emplace_back(model.name);
    if (std::ranges::find(names, name) != names.end()) return name;
    throw InputError(fmt::format("is no model by which paints are read here{}; there are: {}",
                                 did_you_mean(name, names), fmt::join(names, ", ")));
}

}  // namespace nacre::studio
