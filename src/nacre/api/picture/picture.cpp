#include <fmt/format.h>
#include <fmt/ranges.h>

#include <variant>

#include "nacre/core/file.h"
#include "nacre/core/sha256.h"
#include "nacre/io/described_toml.h"
#include "nacre/io/named_files.h"
#include "nacre/models/models.h"
#include "nacre/render.h"
#include "nacre/render/builtin_scenes.h"
#include "nacre/render/mesh_file.h"
#include "nacre/render/render_image.h"
#include "nacre/render/scene_description.h"
#include "nacre/render/scene_file.h"

namespace nacre {

namespace {

namespace fs = std::filesystem;

/// Opens each file and makes each look once.
class Painter {
 public:
    Painter(const ScenePaints& paints, double specimen, const Progress& progress)
        : paints_(paints),
          model_(paints.model.value_or(models::default_picture_model())),
          progress_(progress) {
        if (paints.specimen != 0) model_.set_specimen(paints.specimen);
        if (model_.specimen() == 0) model_.set_specimen(static_cast<std::uint64_t>(specimen));
    }

    /// Of all recipes.
    const Model& model() const { return model_; }

    /// The model that shows a paint; that of recipes for a measured one, which takes none.
    Model model_of(std::size_t paint) const {
        if (paints_.model || opened_[paint].paint.kind() != Kind::brdf_table) return model_;
        Model model = models::default_model();
        if (const auto specimen = model_.specimen()) model.set_specimen(*specimen);
        return model;
    }

    /// The same on the shapes of a material; none if it is measured.
    std::optional<Model> model_on(const render::SceneDescription& scene,
                                  const std::string& material, std::size_t paint) const {
        if (opened_[paint].paint.kind() == Kind::measured_brdf) return std::nullopt;
        Model model = model_of(paint);
        try {
            model.lie_on(material, render::painted_shapes(scene, material));
        } catch (const DomainError& error) {
            throw SettingError("model", error.what(), std::string(model.info().name));
        }
        return model;
    }

    std::shared_ptr<const bsdf::Bsdf> appearance(std::size_t paint,
                                                 const std::optional<Model>& model) {
        for (const Look& known : opened_[paint].looks) {
            if (!known.model || *known.model == *model) return known.surface;
        }
        auto surface = opened_[paint].paint.appearance(model, {}, progress_);
        opened_[paint].looks.push_back({model, surface});
        return surface;
    }

    /// Position among the paints of one that a material names; the slot's without a name.
    std::size_t find(const fs::path& path, const std::string& material,
                     const References& references) {
        for (std::size_t i = 0; i < opened_.size(); ++i) {
            if (opened_[i].path == path) return i;
        }
        if (path.empty() && !paints_.slot) {
            throw SettingError(
                "slot", fmt::format("the material {} has no recipe, and there is no paint for it",
                                    material));
        }
        const auto known = paints_.known.find(path);
        opened_.push_back({path,
                           path.empty()                   ? *paints_.slot
                           : known != paints_.known.end() ? known->second
                                                          : open(path, references.beside(path)),
                           {}});
        return opened_.size() - 1;
    }

    const Paint& paint(std::size_t i) const { return opened_[i].paint; }
    std::vector<Paint> all() const {
        std::vector<Paint> paints;
        for (const Opened& one : opened_) paints.push_back(one.paint);
        return paints;
    }
    std::map<fs::path, Paint> named() const {
        std::map<fs::path, Paint> paints;
        for (const Opened& one : opened_) {
            if (!one.path.empty()) paints.emplace(one.path, one.paint);
        }
        return paints;
    }

 private:
    struct Look {
        std::optional<Model> model;  // none: measured, and the only look
        std::shared_ptr<const bsdf::Bsdf> surface;
    };
    struct Opened {
        fs::path path;
        Paint paint;
        std::vector<Look> looks;
    };

    const ScenePaints& paints_;
    Model model_;
    const Progress& progress_;
    std::vector<Opened> opened_;
};

/// The models that show the coat and the lean of a solved paint.
std::vector<std::string_view> models_of_solutions() {
    return models::names_where(
        [](const bsdf::ModelInfo& model) { return model.solution != bsdf::Solution::none; });
}

/// Of the triangles that a mesh file was read as.
std::string mesh_sha256(const render::Mesh& mesh) {
    Sha256 sum;
    const auto add = [&](const auto& values) {
        sum.update(fmt::format("{}\n", values.size()));
        sum.update(values.data(), values.size() * sizeof(values[0]));
    };
    add(mesh.positions_mm);
    add(mesh.normals);
    add(mesh.uv);
    add(mesh.triangles);
    return sum.hex();
}

/// Of a mesh file and, of a glTF, those that it names. The materials of an OBJ are not read.
std::string mesh_sha256(const fs::path& mesh, const References& references) {
    std::string all = sha256_hex(read_file(mesh, render::kMaxMeshBytes));
    if (lowercase(mesh.extension().string()) == ".obj") return sha256_hex(all);
    for (const fs::path& named : io::files_named_by(mesh, references.beside(mesh))) {
        all += sha256_hex(read_file(named, render::kMaxMeshBytes));
    }
    return sha256_hex(all);
}

/// SHA-256 of all that a scene shows, whatever its files are called and where they lie.
/// @param paints  by material
std::string sha256_of(render::SceneDescription scene,
                      const std::map<std::string, std::string>& paints) {
    scene.name.clear();
    for (render::Shape& shape : scene.shapes) {
        if (auto* mesh = std::get_if<render::MeshFile>(&shape.geometry)) {
            mesh->path =
                mesh->read ? mesh_sha256(*mesh->read) : mesh_sha256(mesh->path, scene.references);
        }
    }
    Sha256 sum;
    // Their descriptions name a file, not its pixels.
    const auto add_pixels = [&](std::string_view of, const auto& image) {
        sum.update(fmt::format("{}: {} x {}\n", of, image.width, image.height));
        sum.update(image.rgb.data(), image.rgb.size() * sizeof(float));
    };
    for (auto& [name, material] : scene.materials) {
        if (auto* paint = std::get_if<render::PaintMaterial>(&material)) {
            paint->recipe = paints.at(name);
        } else if (const auto* seen = std::get_if<render::DiffusePictureMaterial>(&material)) {
            add_pixels(name, *seen);
        }
    }
    if (scene.environment) {
        const auto* image = std::get_if<render::ImageEnvironment>(&*scene.environment);
        if (image) add_pixels("environment", *image);
    }
    sum.update(io::write_described(paint::Described::to_inspect(scene)));
    return sum.hex();
}

}  // namespace

render::SceneDescription find_scene(const std::string& name) {
    return find_scene(name, References::of_file(name));
}

render::SceneDescription find_scene(const std::string& name, const References& references) {
    if (is_stream(name) || fs::exists(name) || fs::path(name).has_extension()) {
        return render::read_scene(name, references);
    }
    return render::builtin_scene(name);
}

std::vector<std::string> paint_slots(const render::SceneDescription& scene) {
    std::vector<std::string> slots;
    for (const auto& [name, material] : scene.materials) {
        const auto* paint = std::get_if<render::PaintMaterial>(&material);
        if (paint && paint->recipe.empty()) slots.push_back(name);
    }
    return slots;
}

io::Image Picture::image() const {
    io::Image image = render::image_of(result, metadata);
    image.metadata["nacre:rgb_sha256"] = io::rgb_sha256(image);
    return image;
}

void Picture::write(const fs::path& path, const ToneMap& tone_map) const {
    if (path.extension() == ".exr") return io::write_exr(path, image());
    if (path.extension() == ".png") return io::write_png(path, image(), tone_map);
    throw SettingError("path", "must end in .exr or .png", path.string());
}

Scene::Scene(render::SceneDescription description, const ScenePaints& paints,
             const Progress& progress)
    : name_(description.name) {
    Painter painter(paints, description.specimen, progress);
    render::PaintTable table;
    std::map<std::string, std::string> shown;
    std::optional<Model> shown_by;  // that of recipes, or where there are none that of tables
    // Of the materials, the positions of their paints, all of which are read before the first is solved.
    std::map<std::string, std::size_t> painted;
    const auto naming_place = [](const render::PaintMaterial& wanted, const auto& work) {
        try {
            work();
        } catch (const InputError& error) {
            // The paint of the slot is not of the scene.
            if (wanted.recipe.empty()) throw;
            throw InputError(wanted.named_at.place + error.what());
        }
    };
    for (const auto& [name, material] : description.materials) {
        const auto* wanted = std::get_if<render::PaintMaterial>(&material);
        if (!wanted) continue;
        naming_place(*wanted, [&, &name = name] {
            painted[name] = painter.find(wanted->recipe, name, description.references);
        });
    }
    for (const auto& [name, found] : painted) {
        const auto& wanted = std::get<render::PaintMaterial>(description.materials.at(name));
        naming_place(wanted, [&, &name = name, found = found] {
            const std::optional<Model> model = painter.model_on(description, name, found);
            table[name] = painter.appearance(found, model);
            if (model) model_settings_[name] = model->text();
        });
        const Paint& paint = painter.paint(found);
        const auto require_shown = [&, &name = name, found = found](const char* key, bool is_there,
                                                                    bool shown) {
            if (!is_there || shown) return;
            throw SettingError(
                "model",
                fmt::format("does not show the {} of the paint of the material {}; must be {}", key,
                            name, fmt::join(models_of_solutions(), " or ")),
                std::string(painter.model_of(found).info().name));
        };
        if (paint.has_recipe()) {
            require_shown("lean", paint.recipe().flake_lean().has_value(),
                          table[name]->flake_lean() || table[name]->leans_by_itself());
            require_shown("clearcoat.orange_peel", paint.recipe().orange_peel().has_value(),
                          table[name]->coat_waves());
            require_shown("clearcoat.thickness_spread_um", paint.recipe().coat_spread() > 0,
                          table[name]->coat_thickness());
        }
        if (paint.kind() != Kind::measured_brdf) {
            if (!shown_by || paint.kind() != Kind::brdf_table) shown_by = painter.model_of(found);
        }
        if (paint.has_recipe()) recipe_sha256_[name] = paint.recipe_sha256();
        shown[name] = fmt::format("{} {} {}", paint.recipe_sha256(), paint.file_sha256(),
                                  painter.model_of(found).text());
    }
    paints_ = painter.all();
    named_paints_ = painter.named();
    shows_model_ = shown_by.has_value();
    model_name_ = shown_by        ? shown_by->info().name
                  : table.empty() ? painter.model().info().name
                                  : "measured";
    if (shown_by) specimen_ = shown_by->specimen();
    compiled_.emplace(description, table);
    turned_deg_ = description.turned_deg;
    sha256_ = sha256_of(std::move(description), shown);
}

std::map<std::string, std::string> Scene::metadata(const RenderSettings& settings) const {
    std::map<std::string, std::string> all = {{"nacre:scene", name_},
                                              {"nacre:model", model_name_},
                                              {"nacre:seed", fmt::format("{}", settings.seed)}};
    if (specimen_) all["nacre:specimen"] = fmt::format("{}", *specimen_);
    for (const auto& [name, hash] : recipe_sha256_) all["nacre:recipe_sha256:" + name] = hash;
    for (const auto& [name, text] : model_settings_) all["nacre:model_settings:" + name] = text;
    if (!turned_deg_.empty()) {
        std::string what, by;
        for (const auto& [name, angle_deg] : turned_deg_) {
            what += (what.empty() ? "" : ", ") + name;
            by += fmt::format("{}{}", by.empty() ? "" : ", ", angle_deg);
        }
        all["nacre:turntable"] = what;
        all["nacre:turn_deg"] = by;
    }
    return all;
}

PictureShard Scene::shard_of(const RenderSettings& settings, const Shard& shard,
                             render::RenderSums sums) const {
    return {settings, shard, std::move(sums), metadata(settings), sha256_};
}

Picture Scene::render(const RenderSettings& settings, const Progress& progress) const {
    return {render::render(*compiled_, settings, progress),
            render::picture_metadata(shard_of(settings, {}, {}))};
}

PictureShard Scene::render_shard(const RenderSettings& settings, const Shard& shard,
                                 const Progress& progress) const {
    return shard_of(settings, shard, render::render_shard(*compiled_, settings, shard, progress));
}

std::optional<PictureShard> Scene::find_shard(const fs::path& file, const RenderSettings& settings,
                                              const Shard& shard) const {
    if (!fs::is_regular_file(file)) return std::nullopt;
    try {
        PictureShard found = read_shard(file);
        const PictureShard wanted = shard_of(settings, shard, {});
        const bool same =
            found.shard == shard && render::identity_of(found) == render::identity_of(wanted);
        return same ? std::optional(std::move(found)) : std::nullopt;
    } catch (const InputError&) {
        return std::nullopt;
    }
}

int Scene::samples_for_noise(const RenderSettings& settings, double noise, int most,
                             const Progress& progress) const {
    return render::samples_for_noise(*compiled_, settings, noise, most, progress);
}

}  // namespace nacre
