#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "nacre/core/file.h"
#include "nacre/core/parallel.h"
#include "nacre/core/progress.h"
#include "nacre/door/state.h"
#include "nacre/fit/free_keys.h"
#include "nacre/fit/remedy.h"
#include "nacre/io/measurement_file.h"
#include "nacre/library.h"
#include "nacre/measure/difference.h"

namespace nacre {
namespace {

namespace fs = std::filesystem;

constexpr const char* kReadings = "readings.csv";
constexpr const char* kRecipe = "recipe.toml";
constexpr std::size_t kMaxRecordBytes = std::size_t{1} << 26;

/// All records, in the order of their names.
std::vector<fs::path> record_folders(const fs::path& library) {
    const fs::path records = library / "records";
    std::error_code error;
    std::vector<fs::path> folders;
    for (const fs::directory_entry& shelf : fs::directory_iterator(records, error)) {
        if (!shelf.is_directory()) continue;
        for (const fs::directory_entry& record : fs::directory_iterator(shelf.path(), error)) {
            if (record.is_directory()) folders.push_back(record.path());
        }
    }
    if (folders.empty()) {
        throw InputError(fmt::format(
            "--library = {}: has no records; nacre-library run makes a library", library.string()));
    }
    std::sort(folders.begin(), folders.end());
    return folders;
}

/// Of a record's readings from the standard; infinite where they have no geometry in common.
NearestRecord compared(const fs::path& folder, const Measurement& standard) {
    NearestRecord record;
    record.folder = folder;
    const Measurement readings = io::read_measurement(folder / kReadings);
    try {
        const measure::Difference found = measure::difference(standard, readings);
        record.mean_delta_e_2000 = found.mean_delta_e_2000;
        record.shared_geometries = found.angles.size();
    } catch (const DomainError&) {
        record.mean_delta_e_2000 = std::numeric_limits<double>::infinity();
    }
    return record;
}

/// What record.json says besides.
void describe(NearestRecord& record) {
    const fs::path file = record.folder / "record.json";
    try {
        const auto json = nlohmann::json::parse(read_file(file, kMaxRecordBytes));
        record.name = json.at("name").get<std::string>();
        record.construction = json.at("construction").get<std::string>();
        for (const auto& [key, value] : json.at("swept").items()) {
            if (value.is_number()) record.swept.push_back(key);
        }
    } catch (const nlohmann::json::exception& error) {
        throw InputError(
            fmt::format("{}: is no record of a library: {}", file.string(), error.what()));
    }
}

/// Whether a number is one that painters turn: not an index, nor a size that colours hardly show.
bool is_turned(std::string_view key) {
    constexpr std::string_view kEnds[] = {
        "volume_fraction",       "mass_fraction",     "orientation.alpha",    "absorption_per_mm",
        "absorption_per_mm.max", "scattering_per_mm", "scattering_per_mm.max"};
    if (key.find("coats[") != std::string_view::npos && key.ends_with("].thickness_nm"))
        return true;
    return std::any_of(std::begin(kEnds), std::end(kEnds),
                       [&](std::string_view end) { return key.ends_with(end); });
}

void seek_remedies(ConstructionMatch& best, const Measurement& standard,
                   const FitSettings& settings, const Progress& progress) {
    Match& match = best.match;
    const Paint start = open(best.start.folder / kRecipe);
    SharedProgress work(progress, 1);
    match.remedies = fit::find_remedies(
        fit::Target(standard, settings.target), match.recipe, start.recipe(), match.parameters,
        match.difference.mean_delta_e_2000, work, match.effort.solves);
    work.require_going("the search for what might help");
}

}  // namespace

std::vector<NearestRecord> nearest_constructions(const fs::path& library,
                                                 const Measurement& standard, std::size_t most,
                                                 const Progress& progress) {
    const std::vector<fs::path> folders = record_folders(library);
    std::vector<NearestRecord> records(folders.size());
    constexpr std::size_t kAtOnce = 256;
    for (std::size_t first = 0; first < folders.size(); first += kAtOnce) {
        const std::size_t last = std::min(first + kAtOnce, folders.size());
        parallel_for(first, last,
                     [&](std::size_t i) { records[i] = compared(folders[i], standard); });
        if (progress &&
            !progress(static_cast<double>(last) / static_cast<double>(folders.size()))) {
            throw Stopped("stopped while a library was read");
        }
    }
    std::erase_if(records, [](const NearestRecord& r) { return r.shared_geometries == 0; });
    if (records.empty()) {
        throw InputError(fmt::format(
            "--library = {}: none of its {} records has readings at a geometry of the standard's",
            library.string(), folders.size()));
    }
    std::stable_sort(records.begin(), records.end(),
                     [](const NearestRecord& a, const NearestRecord& b) {
                         return a.mean_delta_e_2000 < b.mean_delta_e_2000;
                     });
    std::vector<NearestRecord> nearest;
    std::set<std::string> seen;
    for (NearestRecord& record : records) {
        if (nearest.size() == most) break;
        describe(record);
        if (seen.insert(record.construction).second) nearest.push_back(std::move(record));
    }
    return nearest;
}

std::vector<std::string> keys_to_fit(const NearestRecord& record, const Paint& paint,
                                     const FitSettings& settings, const Progress& progress) {
    // A sweep may vary what no fit can: a diameter, which does not change the mean colour.
    std::vector<std::string> keys = paint.free_keys({"*"}, settings, progress).keys;
    const auto varies = [&](const std::string& key) {
        return std::find(record.swept.begin(), record.swept.end(), key) != record.swept.end();
    };
    const bool by_sweep = std::any_of(keys.begin(), keys.end(), varies);
    std::erase_if(keys, [&](const auto& key) { return by_sweep ? !varies(key) : !is_turned(key); });
    return keys;
}

std::vector<ConstructionMatch> fit_from_library(const fs::path& library,
                                                const Measurement& standard, std::size_t most,
                                                const FitSettings& settings,
                                                const Progress& progress) {
    const std::vector<NearestRecord> nearest =
        nearest_constructions(library, standard, most, only_asking(progress));
    FitSettings alone = settings;
    alone.remedies = false;
    std::vector<ConstructionMatch> matches;
    for (const NearestRecord& record : nearest) {
        const Paint paint = open(record.folder / kRecipe);
        const auto part = [&](double fraction) {
            const double done = static_cast<double>(matches.size()) + fraction;
            return !progress || progress(done / static_cast<double>(nearest.size()));
        };
        matches.push_back(
            {record, paint.fit(standard, keys_to_fit(record, paint, alone, part), alone, part)});
    }
    std::stable_sort(
        matches.begin(), matches.end(), [](const ConstructionMatch& a, const ConstructionMatch& b) {
            return a.match.difference.mean_delta_e_2000 < b.match.difference.mean_delta_e_2000;
        });
    ConstructionMatch& best = matches.front();
    if (settings.remedies && !best.match.matched()) {
        seek_remedies(best, standard, settings, only_asking(progress));
    }
    return matches;
}

}  // namespace nacre
