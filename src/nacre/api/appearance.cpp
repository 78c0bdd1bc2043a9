#include <fmt/format.h>
#include <tbb/task_arena.h>

#include "nacre/api/state.h"
#include "nacre/core/file.h"
#include "nacre/models/models.h"
#include "nacre/models/spectral_brdf.h"
#include "nacre/solver/solver.h"
#include "nacre/spectra/spectrum.h"

// The surface and the values of a paint: those of the solved paint itself, of a model made from it
// or from its recipe, of a table, or of a measured BRDF.

namespace nacre {

namespace {

// As large as a car.
constexpr Range kPlace_mm{-1e4, 1e4, "mm"}, kSide_mm{0, 1e4, "mm", true};
constexpr Range kPlaceFraction{0, 1}, kSideFraction{0, 1, "", true};

void require(const Range& range, const char* setting, double value) {
    if (!range.contains(value)) {
        throw SettingError(setting, "must be a number in " + range.text(),
                           fmt::format("{}", value));
    }
}

/// The model that renders from tables.
std::string_view name_of_tabulated() {
    for (const bsdf::ModelInfo* info : models::all_models()) {
        if (info->solution == bsdf::Solution::table) return info->name;
    }
    return "";
}

/// A square on a flat panel that faces +z, as in render::FlatPanel.
bsdf::Patch square_mm(double x, double y, float side) {
    const Vec3f position_mm{static_cast<float>(x), static_cast<float>(y), 0}, normal{0, 0, 1};
    const Frame frame = Frame::around(normal);
    bsdf::Patch patch;
    patch.footprint = {position_mm, normal, frame.s, {side * frame.s, side * frame.t}};
    return patch;
}

/// The values of a surface on patches, made when the first of them is looked at.
class ValuesOnPatch {
 public:
    ValuesOnPatch(Paint paint, Model model, SolveSettings solve, std::vector<double> wavelengths_nm)
        : paint_(std::move(paint)),
          model_(std::move(model)),
          solve_(std::move(solve)),
          wavelengths_nm_(std::move(wavelengths_nm)) {}

    measure::Brdf on(const bsdf::Patch& patch) {
        std::call_once(made_, [&] {
            // Isolated, as Paint::solved(): who waits for parts of this must not begin other work of
            // the caller's, which might wait for all of it.
            tbb::this_task_arena::isolate([&] {
                bound_ = std::make_shared<const models::SpectralBrdf>(
                    *paint_.appearance(model_, solve_), wavelengths_nm_);
            });
        });
        return [bound = bound_, patch](double theta_i, double theta_o, double phi) {
            return (*bound)(theta_i, theta_o, phi, patch);
        };
    }

 private:
    const Paint paint_;
    const Model model_;
    const SolveSettings solve_;
    const std::vector<double> wavelengths_nm_;
    std::once_flag made_;
    std::shared_ptr<const models::SpectralBrdf> bound_;
};

/// The values at those of a solved paint's wavelengths that were asked for.
measure::Brdf solved_values(std::shared_ptr<const solver::SolvedPaint> paint,
                            std::vector<std::size_t> positions, Part part) {
    return [paint = std::move(paint), positions = std::move(positions), part](
               double theta_i, double theta_o, double phi) {
        const std::vector<double> all = paint->brdf(theta_i, theta_o, phi, part);
        std::vector<double> values;
        values.reserve(positions.size());
        for (std::size_t position : positions) values.push_back(all[position]);
        return values;
    };
}

}  // namespace

Range PaintBrdf::place_range() const {
    return coordinates_ == bsdf::SurfaceCoordinates::object_space ? kPlace_mm : kPlaceFraction;
}

Range PaintBrdf::side_range() const {
    return coordinates_ == bsdf::SurfaceCoordinates::object_space ? kSide_mm : kSideFraction;
}

PaintBrdf PaintBrdf::on(double x, double y, double side) const {
    if (!values_on_) throw SettingError("patch", "the surface is alike everywhere");
    require(place_range(), "x", x);
    require(place_range(), "y", y);
    require(side_range(), "side", side);
    const auto edge = static_cast<float>(side);
    PaintBrdf on_patch = *this;
    on_patch.values_ = values_on_(coordinates_ == bsdf::SurfaceCoordinates::object_space
                                      ? square_mm(x, y, edge)
                                      : bsdf::Patch{x, y, {edge, 0}, {0, edge}});
    return on_patch;
}

std::shared_ptr<const bsdf::Bsdf> Paint::State::cached_surface(const Model& model,
                                                               const SolveSettings& solve) const {
    const std::lock_guard lock(mutex);
    for (const CachedSurface& look : surfaces) {
        if (look.model == model && look.solve == solve) return look.surface.lock();
    }
    return nullptr;
}

std::shared_ptr<const bsdf::Bsdf> Paint::appearance(const std::optional<Model>& model,
                                                    const SolveSettings& solve,
                                                    const Progress& progress) const {
    if (const auto* measured = std::get_if<MeasuredBrdf>(&state_->contents)) {
        if (model) {
            throw InputError(fmt::format(
                "{}: holds a measured BRDF, which is shown as it was measured: it takes no model",
                state_->label()));
        }
        return measured->surface;
    }
    const Model shown = model.value_or(models::default_model());
    if (auto known = state_->cached_surface(shown, solve)) return known;
    bsdf::ModelInput input;
    if (const auto* table = std::get_if<bsdf::BrdfTable>(&state_->contents);
        table && shown.info().solution != bsdf::Solution::none) {
        if (shown.info().solution != bsdf::Solution::table) {
            throw InputError(
                fmt::format("{}: holds a table of a BRDF, from which only the model {} renders",
                            state_->label(), name_of_tabulated()));
        }
        try {
            shown.require_kind(*table, state_->label());
        } catch (const DomainError& error) {
            throw SettingError(error.what());
        }
        input.table = *table;
    } else {
        if (shown.info().solution != bsdf::Solution::none) {
            input.solved = solved(solve, cancel_only(progress));
        }
        input.recipe = recipe();
    }
    auto look = state_->naming_file([&] { return shown.make(input, progress); });
    const std::lock_guard lock(state_->mutex);
    std::erase_if(state_->surfaces,
                  [](const State::CachedSurface& l) { return l.surface.expired(); });
    state_->surfaces.push_back({shown, solve, look});
    return look;
}

PaintBrdf Paint::brdf(const BrdfSettings& settings, const Progress& progress) const {
    const bool has_table = kind() == Kind::brdf_table, measured = kind() == Kind::measured_brdf;
    const Model model = settings.model.value_or(models::default_model());
    const bsdf::ModelInfo& info = model.info();
    if (!measured && info.can.reference_only) {
        throw SettingError("model", "follows light and has no values to give",
                           std::string(info.name));
    }
    // The values are those of the solved paint where the model is no more than its solution.
    const bool has_exact_values = !measured && !has_table && info.can.parts && !model.makes_table();
    // Their lean is a matter of the surface, not of the solution.
    const bool leans = has_recipe() && recipe().flake_lean();
    const bool as_rendered = settings.as_rendered || leans;
    if (settings.part != Part::total && (!has_exact_values || as_rendered)) {
        throw SettingError("part",
                           fmt::format("{} {}", state_->label(),
                                       measured ? "holds a measured BRDF, which has no parts"
                                       : leans  ? "has flakes that lean, whose parts are not told"
                                       : info.can.parts ? "holds a table, which does not know parts"
                                                        : "is shown by a model without parts"));
    }
    PaintBrdf brdf;
    brdf.wavelengths_nm_ = settings.wavelengths_nm;
    SolveSettings solve;
    if (has_exact_values) {
        solve.wavelengths_nm = settings.wavelengths_nm;
        const auto paint = solved(solve, cancel_only(progress));
        if (brdf.wavelengths_nm_.empty()) brdf.wavelengths_nm_ = paint->wavelengths_nm();
        if (!as_rendered) {
            std::vector<std::size_t> positions;
            for (double wavelength_nm : brdf.wavelengths_nm_) {
                positions.push_back(wavelength_position(*paint, wavelength_nm, state_->label()));
            }
            brdf.values_ = solved_values(paint, std::move(positions), settings.part);
            return brdf;
        }
    }
    if (brdf.wavelengths_nm_.empty()) brdf.wavelengths_nm_ = spectra::default_wavelengths_nm();
    // Few who ask for values ask for those of single flakes, which take most of the time.
    const auto* nacre = measured || has_table ? nullptr : model.get<NacreModel>();
    const bool alone = nacre && !settings.patches && !state_->cached_surface(model, solve);
    std::shared_ptr<const bsdf::Bsdf> look;
    if (alone) {
        const auto paint = solved(solve, cancel_only(progress));
        look =
            state_->naming_file([&] { return bsdf::Nacre::mean_alone(paint, *nacre, progress); });
    } else {
        look = appearance(settings.model, solve, progress);
    }
    const auto bound = std::make_shared<const models::SpectralBrdf>(*look, brdf.wavelengths_nm_);
    brdf.values_ = [bound](double theta_i, double theta_o, double phi) {
        return (*bound)(theta_i, theta_o, phi);
    };
    brdf.coordinates_ = look->surface_coordinates();
    if (alone) {
        const auto flakes =
            std::make_shared<ValuesOnPatch>(*this, model, solve, brdf.wavelengths_nm_);
        brdf.values_on_ = [flakes](const bsdf::Patch& patch) { return flakes->on(patch); };
    } else if (look->varies_over_surface()) {
        brdf.values_on_ = [bound](const bsdf::Patch& patch) -> measure::Brdf {
            return [bound, patch](double theta_i, double theta_o, double phi) {
                return (*bound)(theta_i, theta_o, phi, patch);
            };
        };
    }
    return brdf;
}

SparkleReadings measure_sparkle(const bsdf::Bsdf& look, const SparkleSettings& settings,
                                const Progress& progress) {
    measure::PanelPictures pictures = measure::take_pictures(look, settings.camera, progress);
    measure::SparkleMeasurement measurement = measure::measure_pictures(
        settings.camera, pictures, settings.viewing, cancel_only(progress, 1));
    return {std::move(pictures), std::move(measurement)};
}

}  // namespace nacre
