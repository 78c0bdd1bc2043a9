#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>

#include "nacre/core/error.h"
#include "nacre/render.h"

namespace nacre {

namespace {

namespace fs = std::filesystem;

/// @throws InputError naming both files and both values of the first thing in which they differ
void require_same_picture(const PictureShard& shard, const fs::path& file,
                          const PictureShard& first, const fs::path& first_file) {
    const auto its = identity_of(shard), wanted = identity_of(first);
    const std::map<std::string, std::string> by_key(its.begin(), its.end());
    const std::map<std::string, std::string> wanted_by_key(wanted.begin(), wanted.end());
    const auto require = [&](const std::string& key) {
        const auto text = [&](const std::map<std::string, std::string>& all) {
            const auto found = all.find(key);
            return found == all.end() ? std::string("none") : found->second;
        };
        if (text(by_key) == text(wanted_by_key)) return;
        throw InputError(fmt::format(
            "{}: {} = {}, but {} has {}: they are shards of different pictures", file.string(), key,
            text(by_key), first_file.string(), text(wanted_by_key)));
    };
    for (const auto& [key, value] : wanted) require(key);
    for (const auto& [key, value] : its) require(key);  // that the first may lack
}

}  // namespace

Picture merge_shards(std::span<const fs::path> files) {
    if (files.empty()) throw InputError("there are no shards to merge");
    PictureShard whole;
    std::map<int, fs::path> taken;  // by number
    for (const fs::path& file : files) {
        PictureShard shard = read_shard(file);
        if (!taken.empty()) require_same_picture(shard, file, whole, files[0]);
        const auto [before, is_new] = taken.try_emplace(shard.shard.number, file);
        if (!is_new) {
            throw InputError(fmt::format("{}: holds the shard {}/{}, as does {}", file.string(),
                                         shard.shard.number, shard.shard.count,
                                         before->second.string()));
        }
        if (taken.size() == 1) {
            whole = std::move(shard);
        } else {
            whole.sums.add(shard.sums);
        }
    }
    std::vector<std::string> missing;
    for (int number = 1; number <= whole.shard.count; ++number) {
        if (!taken.contains(number)) {
            missing.push_back(fmt::format("{}/{}", number, whole.shard.count));
        }
    }
    if (!missing.empty()) {
        throw InputError(fmt::format("{}: of its picture, shards are missing: {}",
                                     files[0].string(), fmt::join(missing, ", ")));
    }
    return {render::develop(std::move(whole.sums), whole.options), render::picture_metadata(whole)};
}

}  // namespace nacre
