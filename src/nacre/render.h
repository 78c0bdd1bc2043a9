#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "nacre/io/image.h"
#include "nacre/montecarlo/discs/disc_walk.h"
#include "nacre/nacre.h"
#include "nacre/render/render.h"
#include "nacre/render/scene.h"
#include "nacre/render/shard_file.h"

// The part of the front door (nacre/nacre.h) that needs ray tracing: pictures of painted scenes.
//
//   const nacre::Scene scene(nacre::find_scene("sphere"), {.slot = nacre::open("violet.toml")});
//   scene.render({.samples_per_pixel = 64}).write("violet.exr");
//
// Link nacre::picture (find_package(nacre COMPONENTS core render)).

namespace nacre {

using io::ToneMap;
using montecarlo::ExplicitFlakesModel;
using RenderSettings = render::RenderOptions;
using render::PictureShard;
using render::read_shard;
using render::Shard;
using render::write_shard;

/// A scene file, or a built-in scene by its name ("sphere"); a file of that name comes first.
/// @throws InputError naming the file and what is wrong in it, or the scenes that there are
render::SceneDescription find_scene(const std::string& name);
/// The same for a file from elsewhere, with the files that it and its recipes may name.
render::SceneDescription find_scene(const std::string& name, const References& references);

/// The materials of a scene that wait for a paint: those that name no recipe.
std::vector<std::string> paint_slots(const render::SceneDescription& scene);

/// What lies on the shapes of a scene.
struct ScenePaints {
    std::optional<Paint> slot = {};  ///< for materials without a recipe; none if there are none
    /// Of all recipes; measured BRDFs take none. Without it models::default_picture_model(), and of
    /// tables models::default_model(), which they hold. Its specimen is that of the scene's description
    /// unless it has another than 0.
    std::optional<Model> model = {};
    /// Unless 0, in place of the model's own, also where that is none.
    std::uint64_t specimen = 0;
    /// By the file that a material names, paints that need not be read and solved again:
    /// Scene::named_paints() of another picture of the scene.
    std::map<std::filesystem::path, Paint> known = {};
};

struct Picture {
    render::RenderResult result;
    /// How it was made, as docs/commands.md lists it.
    std::map<std::string, std::string> metadata;

    io::Image image() const;
    /// By its extension: .exr, with every channel in linear light, or .png, tone-mapped.
    /// @throws DomainError if it is another one; InputError, Error as io/image.h
    void write(const std::filesystem::path& path, const ToneMap& tone_map = {}) const;
};

/// The picture of the shards in these files, which must be all of one picture, each once, in any
/// order: the one that Scene::render() makes, bit for bit, but for the seconds, which are added up.
/// @throws InputError as read_shard(); naming a file, what does not fit, and both values if it holds a
///         shard of another picture; if a shard is missing or there twice
Picture merge_shards(std::span<const std::filesystem::path> files);

/// A scene ready to be rendered; a value, copies share what it holds.
class Scene {
 public:
    /// Reads the files that the scene names and makes each paint once for all materials and shapes
    /// that it is alike on.
    /// @param progress  of each paint that takes long to prepare
    /// @throws InputError, DomainError, Error as open(), Paint::appearance() and render::Scene;
    ///         DomainError if a slot has no paint, or the model does not go on a shape
    explicit Scene(render::SceneDescription description, const ScenePaints& paints = {},
                   const Progress& progress = {});

    /// The paints on it, each once.
    const std::vector<Paint>& paints() const { return paints_; }
    /// Those of recipes that materials name, by the file: not the slot's.
    const std::map<std::filesystem::path, Paint>& named_paints() const { return named_paints_; }
    /// Of the recipes, by material.
    const std::map<std::string, std::string>& recipe_sha256() const { return recipe_sha256_; }
    /// Model::text() of the model that shows it, by material; of measured BRDFs none.
    const std::map<std::string, std::string>& model_settings() const { return model_settings_; }
    /// SHA-256 of all that is seen, whatever its files are called: shards of one picture have the same.
    const std::string& sha256() const { return sha256_; }
    /// The name of the model that shows its recipes, or where there are none its tables; "measured" where
    /// there is neither.
    const std::string& model_name() const { return model_name_; }
    /// Whether a model shows any of the paints: not where all are measured, or there are none.
    bool shows_model() const { return shows_model_; }
    /// Which panel of the batch is seen; none if no model shows single flakes.
    std::optional<std::uint64_t> specimen() const { return specimen_; }

    /// The same bits for any number of threads; where `progress` asks to stop, what there is.
    /// @throws DomainError naming a setting out of range
    Picture render(const RenderSettings& settings = {}, const Progress& progress = {}) const;
    /// One shard of that picture's samples; merge_shards() makes the picture of all of them.
    /// @throws DomainError naming a setting out of range; Stopped if `progress` asks to stop
    PictureShard render_shard(const RenderSettings& settings, const Shard& shard,
                              const Progress& progress = {}) const;
    /// That shard where a file holds it already, of an earlier run; none if there is no such file, or
    /// it is damaged or holds something else.
    std::optional<PictureShard> find_shard(const std::filesystem::path& file,
                                           const RenderSettings& settings,
                                           const Shard& shard) const;
    /// The samples a pixel that a noise needs: render::samples_for_noise().
    /// @throws DomainError naming a setting out of range; Stopped if `progress` asks to stop
    int samples_for_noise(const RenderSettings& settings, double noise, int most,
                          const Progress& progress = {}) const;

 private:
    std::map<std::string, std::string> metadata(const RenderSettings& settings) const;
    PictureShard shard_of(const RenderSettings& settings, const Shard& shard,
                          render::RenderSums sums) const;

    std::string name_, model_name_, sha256_;
    bool shows_model_ = false;
    std::optional<std::uint64_t> specimen_;
    std::vector<Paint> paints_;
    std::map<std::filesystem::path, Paint> named_paints_;
    std::map<std::string, std::string> recipe_sha256_, model_settings_;  // by material
    std::map<std::string, double> turned_deg_;
    std::optional<render::Scene> compiled_;
};

}  // namespace nacre
