#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "nacre/api/state.h"
#include "nacre/core/file.h"
#include "nacre/core/parallel.h"
#include "nacre/core/progress.h"
#include "nacre/fit/fit.h"
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
            if (value.is_number()) record.swept.push_back({key, value, value});
        }
    } catch (const nlohmann::json::exception& error) {
        throw InputError(
            fmt::format("{}: is no record of a library: {}", file.string(), error.what()));
    }
}

/// Ranges that hold those of another record as well, of the numbers that both have.
void widen(std::vector<paint::ParameterBounds>& ranges,
           const std::vector<paint::ParameterBounds>& others) {
    for (paint::ParameterBounds& range : ranges) {
        for (const paint::ParameterBounds& other : others) {
            if (other.key != range.key) continue;
            range.lo = std::min(range.lo, other.lo);
            range.hi = std::max(range.hi, other.hi);
        }
    }
}

/// The record's paint, whose swept numbers may lie anywhere in the library's ranges, and as far off as
/// those of any paint.
Paint with_bounds(const NearestRecord& record, const Paint& paint) {
    const std::vector<paint::RecipeParameter> numbers = paint::recipe_parameters(paint.recipe());
    std::vector<paint::ParameterBounds> bounds;
    for (const paint::ParameterBounds& range : record.swept) {
        // What is 0 in this record may be none of its numbers: a waviness.
        const auto found = std::ranges::find(numbers, range.key, &paint::RecipeParameter::key);
        if (found == numbers.end()) continue;
        const paint::RecipeParameter& number = *found;
        if (number.value == 0) continue;  // of a 0 nothing tells how large it may become
        const auto usual = fit::default_bounds(paint.recipe(), number.key);
        // In other records it may be 0, which stands for what the number has no value for.
        bounds.push_back({number.key, std::max(std::min(usual.lo, range.lo), number.range.lo),
                          std::min(std::max(usual.hi, range.hi), number.range.hi)});
    }
    return Paint(paint.recipe(), std::move(bounds), paint.deviations(), paint.correlations());
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

/// Constructions that are screened, and of these continued with a coarse descent, for each that is
/// fitted: the nearest record of a sparse sweep may be further from the standard than those of many
/// others.
constexpr std::size_t kScreenedPerFit = 4, kDescendedPerFit = 2;
/// Descents of a rough fit.
constexpr int kRoughStarts = 2;
/// More than a rough fit is above what a fit reaches.
constexpr double kRoughError_delta_e = 3;
/// Of all the work, for the progress.
constexpr double kScreeningFraction = 0.2, kDescendingFraction = 0.2;

/// Progress from 0 to 1 as that from `begin` to `end` of all the work.
Progress part_of(const Progress& progress, double begin, double end) {
    return [&progress, begin, end](double fraction) {
        return !progress || progress(begin + (end - begin) * fraction);
    };
}

/// Where a fit may start.
struct Start {
    NearestRecord record;
    Paint paint;
    std::vector<std::string> keys;
    fit::RoughFit rough;
    bool out_of_reach = false;  ///< its rough fit does not come near to a match

    /// As the rough fit, and the fit of what is out of reach, varies them: flakes lie no flatter
    /// than in the records of the construction, as fewer degrees of tilt make a solve ten times as
    /// long.
    std::vector<paint::ParameterBounds> rough_bounds() const {
        std::vector<paint::ParameterBounds> bounds = paint.bounds();
        for (const std::string& key : keys) {
            if (!key.ends_with("orientation.alpha")) continue;
            const auto swept = std::ranges::find(record.swept, key, &paint::ParameterBounds::key);
            auto range = std::ranges::find(bounds, key, &paint::ParameterBounds::key);
            if (range == bounds.end()) {
                bounds.push_back(fit::default_bounds(paint.recipe(), key));
                range = std::prev(bounds.end());
            }
            const double least = swept == record.swept.end()
                                     ? paint::find_parameter(paint.recipe(), key).value
                                     : swept->lo;
            if (least < range->hi) range->lo = std::max(range->lo, least);
        }
        return bounds;
    }
};

void keep_nearest(std::vector<Start>& starts, std::size_t most) {
    std::stable_sort(starts.begin(), starts.end(), [](const Start& a, const Start& b) {
        return a.rough.delta_e < b.rough.delta_e;
    });
    if (starts.size() > most)
        starts.erase(starts.begin() + static_cast<std::ptrdiff_t>(most), starts.end());
}

/// Those whose rough fits come nearest to the standard, in that order: of all some first steps are
/// made, and the better half of what these leave goes on with a coarse descent.
std::vector<Start> most_promising(const std::vector<NearestRecord>& records,
                                  const Measurement& standard, std::size_t most,
                                  const FitSettings& settings, const Progress& progress) {
    FitSettings rough = settings;
    rough.starts = kRoughStarts;
    std::vector<Start> starts;
    for (const NearestRecord& record : records) {
        Paint paint = with_bounds(record, open(record.folder / kRecipe));
        std::vector<std::string> keys = keys_to_fit(record, paint, rough, cancel_only(progress));
        starts.push_back(
            {record, std::move(paint), std::move(keys), {{}, record.mean_delta_e_2000}});
    }
    if (starts.size() <= most) return starts;
    const auto refine = [&](double begin, double end, const auto& refined) {
        const double each = (end - begin) / static_cast<double>(starts.size());
        for (Start& start : starts) {
            const fit::FreeNumbers numbers(start.paint.recipe(), start.keys, start.rough_bounds());
            start.rough = refined(numbers, start.rough, part_of(progress, begin, begin + each));
            begin += each;
        }
    };
    refine(0, kScreeningFraction, [&](const auto& numbers, const auto&, const Progress& part) {
        return fit::screened(standard, numbers, rough, part);
    });
    keep_nearest(starts, kDescendedPerFit * most);
    refine(kScreeningFraction, kScreeningFraction + kDescendingFraction,
           [&](const auto& numbers, const auto& from, const Progress& part) {
               return fit::descended(standard, numbers, from, rough, part);
           });
    keep_nearest(starts, most);
    for (Start& start : starts) {
        start.out_of_reach = start.rough.delta_e > settings.matched_delta_e + kRoughError_delta_e;
    }
    return starts;
}

void seek_remedies(ConstructionMatch& best, const Measurement& standard,
                   const FitSettings& settings, const Progress& progress) {
    Match& match = best.match;
    const Paint start = open(best.start.folder / kRecipe);
    SharedProgress work(progress, 1);
    match.remedies = fit::find_remedies(
        fit::Target(standard, settings.target), match.recipe, start.recipe(), match.parameters,
        match.difference.mean_delta_e_2000, work, match.effort.solves);
    work.throw_if_stopped("the search for what might help");
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
    parallel_for(0, records.size(), [&](std::size_t i) { describe(records[i]); });
    std::vector<NearestRecord> nearest;
    for (NearestRecord& record : records) {
        const auto same = std::find_if(nearest.begin(), nearest.end(), [&](const auto& other) {
            return other.construction == record.construction;
        });
        if (same != nearest.end()) {
            widen(same->swept, record.swept);
        } else if (nearest.size() < most) {
            nearest.push_back(std::move(record));
        }
    }
    return nearest;
}

std::vector<std::string> keys_to_fit(const NearestRecord& record, const Paint& paint,
                                     const FitSettings& settings, const Progress& progress) {
    // A sweep may vary what no fit can: a diameter, which does not change the mean colour.
    std::vector<std::string> keys = paint.free_keys({"*"}, settings, progress).keys;
    const auto varies = [&](const std::string& key) {
        return std::ranges::find(record.swept, key, &paint::ParameterBounds::key) !=
               record.swept.end();
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
        nearest_constructions(library, standard, kScreenedPerFit * most, cancel_only(progress));
    FitSettings alone = settings;
    alone.remedies = false;
    const double roughly = nearest.size() > most ? kScreeningFraction + kDescendingFraction : 0;
    const std::vector<Start> starts = most_promising(nearest, standard, most, alone, progress);
    std::vector<ConstructionMatch> matches;
    const double each = (1 - roughly) / static_cast<double>(starts.size());
    for (const Start& start : starts) {
        const double begin = roughly + each * static_cast<double>(matches.size());
        const Progress part = part_of(progress, begin, begin + each);
        // What only comes nearest is fitted with as much care as what matches.
        if (start.out_of_reach && !matches.empty()) {
            FitSettings once = alone;
            once.starts = 1;
            const Paint narrow(start.paint.recipe(), start.rough_bounds(), start.paint.deviations(),
                               start.paint.correlations());
            matches.push_back({start.record, narrow.fit(standard, start.keys, once, part)});
        } else {
            matches.push_back({start.record, start.paint.fit(standard, start.keys, alone, part)});
        }
    }
    std::stable_sort(
        matches.begin(), matches.end(), [](const ConstructionMatch& a, const ConstructionMatch& b) {
            return a.match.difference.mean_delta_e_2000 < b.match.difference.mean_delta_e_2000;
        });
    ConstructionMatch& best = matches.front();
    if (settings.remedies && !best.match.matched()) {
        seek_remedies(best, standard, settings, cancel_only(progress));
    }
    return matches;
}

}  // namespace nacre
