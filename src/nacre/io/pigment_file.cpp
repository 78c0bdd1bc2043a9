#include "nacre/io/pigment_file.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "nacre/core/error.h"
#include "nacre/core/file.h"
#include "nacre/core/text.h"
#include "nacre/io/described_toml.h"
#include "nacre/paint/recipe_description.h"

namespace nacre::io {

namespace {

constexpr const char* kSourceKey = "source";
constexpr const char* kVolumeKey = "volume_fraction";
constexpr const char* kMassKey = "mass_fraction";
constexpr std::size_t kMaxPigmentSourceLength = 2000;
constexpr std::size_t kMaxPigmentPathLength = 2000;
/// With which a file is read to see whether it is right.
constexpr double kTrialVolume = 0.1;

bool contains(const std::vector<std::string>& keys, std::string_view key) {
    return std::find(keys.begin(), keys.end(), key) != keys.end();
}

/// What a file of a pigment may say.
std::vector<std::string> keys_of_file() {
    const std::vector<std::string> beside = keys_beside_from();
    std::vector<std::string> keys = {"name", kSourceKey};
    for (std::string& key : paint::keys_of_new<paint::Pigment>()) {
        if (key != "from" && !contains(beside, key)) keys.push_back(std::move(key));
    }
    return keys;
}

PigmentFile read_pigment(TomlDocument& document, double volume_fraction) {
    const TableReader file(document, keys_of_file());
    PigmentFile out;
    out.source = file.text_or(kSourceKey, "", kMaxPigmentSourceLength);
    toml::table keys = document.root();
    keys.erase(kSourceKey);
    keys.insert(kVolumeKey, volume_fraction);
    read_described(file.on(keys, paint::keys_of_new<paint::Pigment>()),
                   paint::Described(out.pigment));
    return out;
}

std::vector<std::string> pigment_names() {
    std::vector<std::string> names;
    for (const ShippedPigment& pigment : shipped_pigments()) names.emplace_back(pigment.name);
    return names;
}

/// The keys of a file, found to be right.
toml::table keys_of_named(std::string_view text, const std::string& filename,
                          const References& references) {
    TomlDocument document(text, filename, references);
    read_pigment(document, kTrialVolume);
    toml::table keys = document.root();
    keys.erase(kSourceKey);
    return keys;
}

toml::table find_keys(const TableReader& table, std::string_view from) {
    const std::string name = table.text(from, kMaxPigmentPathLength);
    for (const ShippedPigment& pigment : shipped_pigments()) {
        if (pigment.name == name) return keys_of_named(pigment.toml, name + ".toml", {});
    }
    // A bare word is meant as a name.
    const std::vector<std::string> names = pigment_names();
    if (!name.ends_with(".toml")) {
        table.fail(from, fmt::format("is none of the pigments that ship, {}, nor a .toml file{}",
                                     fmt::join(names, ", "), did_you_mean(name, names)));
    }
    std::filesystem::path path;
    try {
        path = table.document().references().resolve(name);
    } catch (const InputError& error) {
        table.fail(from, error.what());
    }
    // What it names in turn are materials that ship.
    return keys_of_named(*table.document().references().read(path, kMaxTextBytes), path.string(),
                         References().beside(path));
}

}  // namespace

std::vector<std::string> keys_beside_from() {
    std::vector<std::string> keys = paint::keys_of_new<paint::PigmentVolume>();
    for (std::string& key : paint::keys_of_new<paint::PigmentMass>()) keys.push_back(key);
    keys.emplace_back("name");
    return keys;
}

PigmentFile parse_pigment_file(std::string_view text, const std::string& filename,
                               double volume_fraction) {
    TomlDocument document(text, filename, {});
    return read_pigment(document, volume_fraction);
}

PigmentFile parse_pigment_file(const TypedFile& file, double volume_fraction) {
    const std::shared_ptr<TomlDocument> document = TomlDocument::of(file);
    document->set_references({});
    return read_pigment(*document, volume_fraction);
}

PigmentFile find_pigment(const std::string& name, double volume_fraction) {
    for (const ShippedPigment& pigment : shipped_pigments()) {
        if (pigment.name == name) {
            return parse_pigment_file(pigment.toml, name + ".toml", volume_fraction);
        }
    }
    if (!name.ends_with(".toml")) {
        const std::vector<std::string> names = pigment_names();
        throw InputError(
            fmt::format("{}: is none of the pigments that ship, {}, nor a .toml file{}",
                        excerpt(name), fmt::join(names, ", "), did_you_mean(name, names)));
    }
    TomlDocument document(read_file(name, kMaxTextBytes), name, References::of_file(name));
    return read_pigment(document, volume_fraction);
}

paint::Pigment find_white(const std::string& name) {
    constexpr double kSomeVolume = 0.1;  // about as much as there is in a tint
    return find_pigment(name, kSomeVolume).pigment;
}

bool looks_like_pigment(const TomlDocument& document) {
    const std::vector<std::string> keys = keys_of_file();
    bool more_than_a_name = false;
    for (auto&& [key, node] : document.root()) {
        if (!contains(keys, key.str())) return false;
        more_than_a_name = more_than_a_name || key.str() != "name";
    }
    return more_than_a_name;
}

std::string write_pigment_file(const PigmentFile& file) {
    paint::Pigment pigment = file.pigment;
    if (auto* given = std::get_if<paint::PigmentCoefficients>(&pigment.body)) {
        given->amount = paint::PigmentUnstated{};
    } else if (auto* two_flux = std::get_if<paint::PigmentKubelkaMunk>(&pigment.body)) {
        two_flux->amount = paint::PigmentUnstated{};
    } else {
        throw DomainError("pigment: particles are written with their amount, in a recipe");
    }
    return write_described(paint::Described::to_inspect(pigment)) +
           fmt::format("{} = {}\n", kSourceKey, toml_text(file.source));
}

std::shared_ptr<const toml::table> with_keys_from(const TableReader& table, std::string_view from) {
    toml::table keys = find_keys(table, from);
    const std::vector<std::string> beside = keys_beside_from();
    for (const std::string& key : table.keys()) {
        if (key == from) continue;
        if (!contains(beside, key)) {
            table.fail(key, fmt::format("the file that `{}` names says this; beside it stand {}",
                                        from, fmt::join(beside, ", ")));
        }
    }
    if (!table.has(kVolumeKey) && !table.has(kMassKey)) {
        table.fail(kVolumeKey, paint::amount_is_missing());
    }
    auto whole = std::make_shared<toml::table>(table.contents());
    whole->erase(from);
    for (auto& [key, value] : keys) whole->insert(key, value);  // those of the recipe stay
    return whole;
}

}  // namespace nacre::io
