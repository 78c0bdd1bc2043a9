#include <fmt/format.h>

#include "nacre/api/state.h"
#include "nacre/bsdf/measured/merl.h"
#include "nacre/bsdf/measured/rgl.h"
#include "nacre/bsdf/models/nacre_arrays.h"
#include "nacre/core/file.h"
#include "nacre/exchange/cycles_material.h"
#include "nacre/exchange/gltf_file.h"
#include "nacre/exchange/gltf_material.h"
#include "nacre/exchange/open_pbr.h"
#include "nacre/exchange/threejs_file.h"
#include "nacre/io/brdf_table_file.h"
#include "nacre/io/measured_brdf_file.h"
#include "nacre/io/solved_paint_file.h"
#include "nacre/models/models.h"

namespace nacre {

namespace {

/// A file takes about a million values, so that they are computed as for a renderer.
BrdfSettings fast(BrdfSettings settings) {
    settings.part = Part::total;
    settings.as_rendered = true;
    return settings;
}

/// Where a coat's index is taken for renderers in RGB.
constexpr double kCoatIndexWavelength_nm = 550;

/// Of paints that do not say how large their flakes are.
constexpr double kGuessedFlake_um = 30;

/// Of the uppermost layer with flakes, weighted by their areas; none where there are no flakes.
std::optional<double> mean_flake_um(const paint::Recipe& recipe) {
    for (const paint::Layer& layer : recipe.layers) {
        double areas = 0, diameters = 0;
        for (const paint::FlakeSpecies& species : layer.flakes) {
            const double area = species.area_density_per_um();
            areas += area;
            diameters += area * (species.quantiles ? paint::quantiles_of(*species.quantiles).d50_um
                                                   : species.diameter_um);
        }
        if (areas > 0) return diameters / areas;
    }
    return std::nullopt;
}

/// "nacre, or microflake without tables".
std::string models_with_arrays() {
    std::string names;
    for (const std::string_view name : models::names_with_arrays()) {
        if (!names.empty()) names += ", or ";
        names += name;
        if (models::find_model(name)->solution == bsdf::Solution::table) names += " without tables";
    }
    return names;
}

/// "Violet pearl, nacre", "brass.bsdf, measured".
std::string title(const Paint& paint, const std::optional<Model>& model) {
    const std::string name = paint.has_recipe() && !paint.recipe().name.empty()
                                 ? paint.recipe().name
                                 : std::filesystem::path(paint.file()).filename().string();
    const Model shown = model.value_or(models::default_model());
    return fmt::format("{}, {}", name,
                       paint.kind() == Kind::measured_brdf ? "measured" : shown.info().name);
}

}  // namespace

void Exported::write(const std::filesystem::path& path) const {
    write_file_atomically(path, bytes);
}

void FittedMaterial::write(const std::filesystem::path& path) const {
    write_file_atomically(path, bytes);
}

void ShaderMaterial::write(const std::filesystem::path& path) const {
    write_file_atomically(path, bytes);
}

/// A written file holds one azimuth of incidence; an anisotropic surface must not lose the others
/// silently.
void Paint::State::require_isotropic() const {
    const paint::Recipe* recipe = nullptr;
    if (const auto* file = std::get_if<io::RecipeFile>(&contents)) recipe = &file->recipe;
    if (const auto* solved = std::get_if<std::shared_ptr<const solver::SolvedPaint>>(&contents)) {
        recipe = &(*solved)->recipe;
    }
    if (recipe) {
        naming_file([&] { paint::require_no_lean(*recipe, "files are of paints that are"); });
    }
    const auto* measured = std::get_if<MeasuredBrdf>(&contents);
    if (!measured || measured->isotropic) return;
    throw InputError(fmt::format(
        "{}: holds an anisotropic BRDF; files are written of isotropic ones only", label()));
}

Exported Paint::export_rgl(const RglSettings& rgl, const BrdfSettings& settings,
                           const Progress& progress) const {
    state_->require_isotropic();
    const PaintBrdf values = brdf(fast(settings), cancel_only(progress));
    const bsdf::RglTable table = measure::acquire_rgl(title(*this, settings.model), values,
                                                      values.wavelengths_nm(), rgl, progress);
    const Progress asking = cancel_only(progress, 1);
    SharedProgress work(asking, 1);
    return {io::rgl_bytes(table, asking),
            measure::table_error(bsdf::MeasuredRgl(table, &work), values, values.wavelengths_nm(),
                                 rgl.rgb, asking)};
}

Exported Paint::export_merl(const MerlSettings& merl, const BrdfSettings& settings,
                            const Progress& progress) const {
    state_->require_isotropic();
    const PaintBrdf values = brdf(fast(settings), cancel_only(progress));
    const bsdf::MerlTable table =
        measure::acquire_merl(values, values.wavelengths_nm(), merl, progress);
    const Progress asking = cancel_only(progress, 1);
    SharedProgress work(asking, 1);
    return {io::merl_bytes(table, asking),
            measure::table_error(bsdf::MeasuredMerl(table, &work), values, values.wavelengths_nm(),
                                 true, asking)};
}

FittedMaterial Paint::export_material(MaterialFormat format, const BrdfSettings& settings,
                                      const Progress& progress) const {
    state_->require_isotropic();
    if (kind() == Kind::measured_colours) {
        throw InputError(fmt::format(
            "{}: holds measured colours; a material is fitted to a recipe or a BRDF, at {} lamps "
            "and "
            "views",
            state_->label(),
            exchange::fit_geometries().fitted.size() + exchange::fit_geometries().tested.size()));
    }
    const bool coat = has_recipe() && !recipe().layers.empty();
    const bool rough = coat && recipe().clearcoat && recipe().clearcoat->roughness > 0;
    const exchange::FormatModel model = [&] {
        switch (format) {
            case MaterialFormat::gltf:
                return exchange::gltf_model(coat, rough);
            case MaterialFormat::materialx:
                return exchange::open_pbr_model(coat, rough);
            case MaterialFormat::cycles:
                break;
        }
        const double ior = coat ? recipe().binder.index(kCoatIndexWavelength_nm).real() : 1.5;
        return exchange::cycles_model(coat, rough, ior);
    }();
    const exchange::FitGeometries& sets = exchange::fit_geometries(model.across);
    const MeasureSettings seen{.model = settings.model,
                               .illuminant = Illuminant::D65,
                               .observer = Observer::cie1931_2deg,
                               .wavelengths_nm = settings.wavelengths_nm};
    const Progress asking = cancel_only(progress);
    FittedMaterial made;
    made.format = model.format;
    made.fit = exchange::fit_material(model, measure(sets.fitted, seen, asking).measurement,
                                      measure(sets.tested, seen, asking).measurement, progress);
    for (std::size_t i = 0; i < model.parameters.size(); ++i) {
        made.parameters.emplace_back(model.parameters[i].name, made.fit.values[i]);
    }
    switch (format) {
        case MaterialFormat::gltf:
            made.bytes = exchange::gltf_text(exchange::gltf_material(model, made.fit.values),
                                             name(), made.fit);
            break;
        case MaterialFormat::materialx:
            made.bytes = exchange::materialx_text(exchange::open_pbr(model, made.fit.values),
                                                  name(), made.fit);
            break;
        case MaterialFormat::cycles: {
            const auto material = exchange::cycles_material(model, made.fit.values);
            made.parameters = exchange::cycles_parameters(material);
            made.bytes = exchange::cycles_text(
                material, name(), made.fit,
                has_recipe() ? mean_flake_um(recipe()).value_or(kGuessedFlake_um)
                             : kGuessedFlake_um);
            break;
        }
    }
    return made;
}

bsdf::NacreArrays Paint::arrays(const Model& model, bsdf::ArrayParts parts,
                                const Progress& progress) const {
    if (!model.makes_arrays()) {
        throw SettingError("model", fmt::format("must be {}", models_with_arrays()), model.text());
    }
    const auto paint = solved({}, progress);
    return std::move(
        *state_->naming_file([&] { return model.make_arrays(paint, parts, progress); }));
}

ShaderMaterial Paint::export_threejs(const std::optional<Model>& model,
                                     const Progress& progress) const {
    const Model standard = models::default_picture_model(), shown = model.value_or(standard);
    const auto shader = exchange::make_webgl_shader(arrays(shown, bsdf::ArrayParts::all, progress));
    const Readings paint = measure(
        exchange::shader_geometries(),
        {.model = standard, .illuminant = Illuminant::D65, .observer = Observer::cie1931_2deg},
        cancel_only(progress, 1));
    ShaderMaterial made;
    made.model = shown.info().name;
    made.standard = standard.info().name;
    made.difference = exchange::shader_difference(shader, paint.measurement);
    made.bytes =
        exchange::threejs_text(shader, name(), recipe_sha256(), made.difference, made.standard);
    return made;
}

std::string Paint::export_solved(const SolveSettings& settings, const Progress& progress) const {
    return io::solved_paint_bytes(*solved(settings, progress));
}

std::string Paint::export_table(const Model& model, const SolveSettings& solve,
                                const Progress& progress) const {
    const auto table = model.make_table(*solved(solve, cancel_only(progress)), progress);
    if (!table) {
        throw SettingError("model", "renders from no table, as chosen",
                           std::string(model.info().name));
    }
    return std::visit(
        [&](const auto& t) { return io::brdf_table_bytes(*t, cancel_only(progress, 1)); }, *table);
}

PaintContents Paint::contents() const {
    struct Write {
        PaintContents operator()(const io::RecipeFile& file) const {
            return {io::write_recipe(file.recipe, file.bounds, file.deviations, file.correlations)};
        }
        PaintContents operator()(const std::shared_ptr<const solver::SolvedPaint>& paint) const {
            return {io::solved_paint_bytes(*paint)};
        }
        PaintContents operator()(const bsdf::BrdfTable& table) const {
            return {std::visit([](const auto& t) { return io::brdf_table_bytes(*t); }, table)};
        }
        PaintContents operator()(const MeasuredBrdf& measured) const { return {measured.bytes}; }
        PaintContents operator()(const MeasuredColours& colours) const {
            return {colours.text, colours.sample};
        }
    };
    return std::visit(Write(), state_->contents);
}

}  // namespace nacre
