#include "nacre/render/shard_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <concepts>
#include <cstring>
#include <nlohmann/json.hpp>
#include <type_traits>

#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/core/version.h"
#include "nacre/io/file_kind.h"
#include "nacre/io/hdf5_file.h"

namespace nacre::render {

namespace {

using io::Hdf5Handle;
using io::Hdf5Shape;

constexpr io::SealedFormat kShardFormat = {io::kPictureShardName, kShardFormatVersion,
                                           "shard of a picture"};
constexpr std::size_t kMaxShardPixels = std::size_t{1} << 27;  // as check(RenderOptions)
constexpr std::size_t kMaxMetadataBytes = std::size_t{1} << 20;

/// Calls visit(key, member) for every option.
template <class Options, class Visit>
void for_each_option(Options& options, const Visit& visit) {
    visit("width", options.width);
    visit("height", options.height);
    visit("samples_per_pixel", options.samples_per_pixel);
    visit("seed", options.seed);
    visit("max_depth", options.max_depth);
    visit("footprint_pixels", options.footprint_pixels);
    visit("sparkle", options.sparkle);
    visit("noise", options.noise);
    visit("spectral_bins", options.spectral_bins);
}

void write_option(hid_t group, const char* key, int value) {
    io::write_attribute(group, key, value);
}
void write_option(hid_t group, const char* key, bool value) {
    io::write_attribute(group, key, value ? 1 : 0);
}
void write_option(hid_t group, const char* key, double value) {
    io::write_attribute(group, key, value);
}
void write_option(hid_t group, const char* key, std::uint64_t value) {
    io::write_attribute(group, key, std::to_string(value));
}

void read_option(hid_t group, const char* key, int& value) {
    value = io::read_int_attribute(group, key);
}
void read_option(hid_t group, const char* key, bool& value) {
    value = io::read_int_attribute(group, key) != 0;
}
void read_option(hid_t group, const char* key, double& value) {
    value = io::read_double_attribute(group, key);
}
void read_option(hid_t group, const char* key, std::uint64_t& value) {
    const std::string text = io::read_text_attribute(group, key);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    io::require_content(error == std::errc() && end == text.data() + text.size(),
                        "the seed is no whole number");
}

/// Calls visit(name, values, shape before the words of a value, meaning) for every array of sums.
template <class Sums, class Visit>
void for_each_array(Sums& sums, const Visit& visit) {
    const auto height = static_cast<hsize_t>(sums.height), width = static_cast<hsize_t>(sums.width);
    const auto bins = static_cast<hsize_t>(sums.passes.bin_weights.size());
    const Hdf5Shape pixels = {height, width}, colours = {height, width, 3};
    visit("light", sums.xyz, colours, "XYZ of the paths of each pixel");
    visit("albedo", sums.albedo, colours, "XYZ of the albedo of the first surface under D65");
    if (!sums.sparkle.empty()) {
        visit("sparkle", sums.sparkle, colours, "XYZ of single flakes less that of their mean");
    }
    visit("normal", sums.normal, colours, "normal of the first surface");
    visit("met", sums.met, pixels, "paths that met a surface");
    visit("invalid", sums.invalid, pixels, "paths whose light cannot be summed");
    if (bins > 0) {
        visit("spectral", sums.spectral, {height, width, bins}, "spectral radiance about each bin");
        visit("bin_weights", sums.passes.bin_weights, {bins}, "weights of the spectral sums");
    }
    visit("white", sums.passes.d65, {3}, "XYZ of D65");
    visit("albedo_white", sums.passes.albedo_d65, {3}, "XYZ of D65 in the passes with albedo");
}

/// What HDF5 holds of an array of sums: 64-bit words, two for each sum of light.
template <class Values>
struct Words {
    using Value = std::remove_cvref_t<decltype(*std::declval<const Values&>().data())>;
    static_assert(std::is_trivially_copyable_v<Value>);
    static constexpr bool kCounts = std::same_as<Value, std::uint32_t>;
    static constexpr bool kLight =
        std::same_as<Value, LightSum> || std::same_as<Value, SumTriple<LightSum>>;

    static Hdf5Shape shape(Hdf5Shape of_values) {
        if (kLight) of_values.push_back(2);
        return of_values;
    }
    static const char* unit() {
        return kCounts ? "1" : kLight ? "2^-48, as low and high word" : "2^-38";
    }
};

void write_sums(hid_t file, const char* name, const FilmSums& sums, const char* meaning) {
    const Hdf5Handle group = io::write_group(file, name, meaning);
    io::write_attribute(group, "passes", sums.passes.count);
    for_each_array(sums, [&](const char* array, const auto& values, const Hdf5Shape& of_values,
                             const char* means) {
        using W = Words<std::remove_cvref_t<decltype(values)>>;
        using Word = std::conditional_t<W::kCounts, int, std::int64_t>;
        io::write_array(group, array, W::shape(of_values),
                        reinterpret_cast<const Word*>(values.data()), W::unit(), means);
    });
}

/// @param sums  of the sizes that the file must have
void read_sums(hid_t file, const char* name, int passes, FilmSums& sums) {
    const Hdf5Handle group(H5Gopen2(file, name, H5P_DEFAULT), fmt::format("open group {}", name));
    sums.passes.count = io::read_int_attribute(group, "passes");
    io::require_content(sums.passes.count == passes, "the passes are not those of the shard");
    for_each_array(
        sums, [&](const char* array, auto& values, const Hdf5Shape& of_values, const char*) {
            using W = Words<std::remove_cvref_t<decltype(values)>>;
            const Hdf5Shape shape = W::shape(of_values);
            std::size_t count = 1;
            for (const hsize_t n : shape) count *= n;
            io::require_content(io::array_shape(group, array, shape.size(), count) == shape,
                                "the sizes of the arrays are not those of the picture");
            const auto copy = [&](const auto& words) {
                std::memcpy(static_cast<void*>(values.data()), words.data(),
                            words.size() * sizeof words[0]);
            };
            if constexpr (W::kCounts) {
                copy(io::read_ints(group, array, shape.size(), count));
            } else {
                copy(io::read_int64s(group, array, shape.size(), count));
            }
        });
}

/// Names of files may be no UTF-8.
std::string metadata_text(const PictureShard& shard) {
    return nlohmann::json(shard.metadata)
        .dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::map<std::string, std::string> read_metadata(hid_t file) {
    try {
        return nlohmann::json::parse(io::read_text(file, "metadata", kMaxMetadataBytes))
            .get<std::map<std::string, std::string>>();
    } catch (const nlohmann::json::exception&) {
        throw Error("its metadata are no texts by name");
    }
}

PictureShard read_contents(hid_t file) {
    const std::string made_by = io::read_text_attribute(file, "nacre_version");
    if (made_by != version()) {
        throw Error(
            fmt::format("nacre_version = {}, but this is Nacre {}, whose samples are others",
                        made_by, version()));
    }
    PictureShard shard;
    {
        const Hdf5Handle group(H5Gopen2(file, "options", H5P_DEFAULT), "open group options");
        for_each_option(shard.options,
                        [&](const char* key, auto& value) { read_option(group, key, value); });
    }
    shard.shard = {io::read_int_attribute(file, "number"), io::read_int_attribute(file, "count")};
    check(shard.options, shard.shard);
    shard.scene_sha256 = io::read_text_attribute(file, "scene_sha256");
    shard.metadata = read_metadata(file);
    // A file of a few bytes must not ask for gigabytes.
    const Hdf5Shape light = {static_cast<hsize_t>(shard.options.height),
                             static_cast<hsize_t>(shard.options.width), 3, 2};
    io::require_content(
        io::array_shape(file, "picture/light", light.size(), 6 * kMaxShardPixels) == light,
        "the sizes of the arrays are not those of the picture");
    shard.sums = RenderSums(shard.options);
    shard.sums.seconds = io::read_double_attribute(file, "seconds");
    io::require_content(std::isfinite(shard.sums.seconds) && shard.sums.seconds >= 0,
                        "the seconds are none");
    const int passes = samples_of(shard.options, shard.shard);
    read_sums(file, "picture", passes, shard.sums.picture);
    if (shard.sums.probe) read_sums(file, "probe", passes, *shard.sums.probe);
    return shard;
}

}  // namespace

std::vector<std::pair<std::string, std::string>> identity_of(const PictureShard& shard) {
    std::vector<std::pair<std::string, std::string>> all;
    for_each_option(shard.options, [&](const char* key, const auto& value) {
        all.emplace_back(key, fmt::format("{}", value));
    });
    all.emplace_back("count of shards", fmt::format("{}", shard.shard.count));
    for (const auto& [key, value] : shard.metadata) {
        if (key != "nacre:scene") all.emplace_back(key, value);  // a file may have several names
    }
    // They repeat the specimen among others.
    std::stable_partition(all.begin(), all.end(), [](const auto& one) {
        return !one.first.starts_with("nacre:model_settings:");
    });
    all.emplace_back("scene_sha256", shard.scene_sha256);
    return all;
}

std::map<std::string, std::string> picture_metadata(const PictureShard& shard) {
    std::map<std::string, std::string> all = shard.metadata;
    all["nacre:depth"] = fmt::format("{}", shard.options.max_depth);
    all["nacre:footprint_pixels"] = fmt::format("{}", shard.options.footprint_pixels);
    all["nacre:scene_sha256"] = shard.scene_sha256;
    return all;
}

std::string shard_bytes(const PictureShard& shard) {
    return io::sealed_bytes(kShardFormat, [&](hid_t file) {
        io::write_attribute(file, "scene_sha256", shard.scene_sha256);
        io::write_attribute(file, "number", shard.shard.number);
        io::write_attribute(file, "count", shard.shard.count);
        io::write_attribute(file, "seconds", shard.sums.seconds);
        io::write_text(file, "metadata", metadata_text(shard),
                       "what the picture's file will say, JSON");
        {
            const Hdf5Handle group = io::write_group(file, "options", "of the whole picture");
            for_each_option(shard.options, [&](const char* key, const auto& value) {
                write_option(group, key, value);
            });
        }
        write_sums(file, "picture", shard.sums.picture,
                   "sums over this share's paths of each pixel, and over its passes");
        if (shard.sums.probe) {
            write_sums(file, "probe", *shard.sums.probe,
                       "the same of the pixels that are rendered twice for the noise");
        }
    });
}

void write_shard(const std::filesystem::path& path, const PictureShard& shard) {
    write_file_atomically(path, shard_bytes(shard));
}

PictureShard parse_shard(std::string_view bytes, const std::string& name) {
    const io::FileKind kind = io::file_kind(bytes);
    if (kind != io::FileKind::picture_shard) {
        throw InputError(
            fmt::format("{}: is {}; a shard of a picture (nacre render --shard) is "
                        "needed here",
                        name, io::words_for(kind)));
    }
    PictureShard shard;
    io::read_sealed(kShardFormat, bytes, name, [&](hid_t file) { shard = read_contents(file); });
    return shard;
}

PictureShard read_shard(const std::filesystem::path& path) {
    return parse_shard(read_file(path, kMaxShardBytes), path.string());
}

}  // namespace nacre::render
