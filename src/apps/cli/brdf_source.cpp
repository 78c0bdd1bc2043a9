#include "apps/cli/brdf_source.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <memory>

#include "apps/cli/brdf_options.h"
#include "apps/cli/measured_source.h"
#include "apps/cli/options.h"
#include "apps/cli/paint_source.h"
#include "nacre/models/spectral_brdf.h"

namespace nacre::cli {

namespace {

/// The solved paint itself: in double precision, by parts.
BrdfSource solved_source(const std::filesystem::path& path, const BrdfRequest& request,
                         const std::optional<std::vector<double>>& wanted,
                         const CommonOptions& options) {
    auto paint = std::make_shared<const solver::SolvedPaint>(load_paint(path, wanted, options));
    std::vector<double> wavelengths = wanted.value_or(paint->wavelengths_nm());
    std::vector<std::size_t> positions;
    for (double wavelength : wavelengths) {
        positions.push_back(wavelength_position(*paint, wavelength, path));
    }
    return {paint->recipe, std::move(wavelengths),
            [paint, positions, part = request.part](double theta_i, double theta_o, double phi) {
                const std::vector<double> brdf = paint->brdf(theta_i, theta_o, phi, part);
                std::vector<double> values;
                values.reserve(positions.size());
                for (std::size_t position : positions) values.push_back(brdf[position]);
                return values;
            },
            false};
}

/// The square that --at and --footprint describe, in the terms of the surface; none without them.
std::optional<bsdf::Patch> parse_patch(const BrdfRequest& options,
                                       bsdf::SurfaceCoordinates layout) {
    if (options.at.empty()) return std::nullopt;
    // As large as a car.
    constexpr Range kPlace{-1e4, 1e4, "mm"}, kSide{0, 1e4, "mm", true};
    constexpr Range kFraction{0, 1}, kFractionOfSide{0, 1, "", true};
    const bool in_mm = layout == bsdf::SurfaceCoordinates::object_space;
    const std::vector<std::string> place = split(options.at, ',');
    const double x = parse_number("--at", place[0], in_mm ? kPlace : kFraction);
    const double y = parse_number("--at", place[1], in_mm ? kPlace : kFraction);
    const auto side = static_cast<float>(
        parse_number("--footprint", options.footprint, in_mm ? kSide : kFractionOfSide));
    if (!in_mm) return bsdf::Patch{x, y, {side, 0}, {0, side}};
    // A flat panel that faces +z, as in render::FlatPanel.
    const Vec3f position_mm{static_cast<float>(x), static_cast<float>(y), 0}, normal{0, 0, 1};
    const Frame frame = Frame::around(normal);
    bsdf::Patch patch;
    patch.rest = {position_mm, normal, frame.s, {side * frame.s, side * frame.t}};
    return patch;
}

/// Any model that gives values, through the surface that a renderer sees.
BrdfSource model_source(const std::filesystem::path& path, const BrdfRequest& request,
                        const std::optional<std::vector<double>>& wanted,
                        const CommonOptions& options) {
    PaintSurface paint = load_surface(path, request.model, options);
    const std::optional<bsdf::Patch> patch =
        parse_patch(request, paint.surface->surface_coordinates());
    std::vector<double> wavelengths = wanted.value_or(solver::default_wavelengths_nm());
    const auto brdf = std::make_shared<const models::SpectralBrdf>(*paint.surface, wavelengths);
    return {std::move(paint.recipe), std::move(wavelengths),
            [brdf, patch](double theta_i, double theta_o, double phi) {
                return (*brdf)(theta_i, theta_o, phi, patch);
            },
            false};
}

/// What can be said about --at and --footprint before the paint is made.
void check_patch(const BrdfRequest& options) {
    if (options.at.empty() && options.footprint.empty()) return;
    const bsdf::ModelInfo& model = options.model.info();
    if (!model.can.sparkle) {
        throw UsageError(
            fmt::format("--at and --footprint: {} is alike all over the surface", model.name));
    }
    if (options.at.empty() || options.footprint.empty()) {
        throw UsageError("--at and --footprint belong together");
    }
    if (split(options.at, ',').size() != 2) {
        throw UsageError(fmt::format("--at = {}: must be two numbers, as in 0.25,0.5", options.at));
    }
}

}  // namespace

void require_values(const bsdf::ModelInfo& model) {
    if (!model.can.reference_only) return;
    // The reference walks through layers, in which no flake has a place.
    throw UsageError(fmt::format("{}: follows light and has no values to give; see nacre {}",
                                 choice_of(model), model.can.sparkle ? "render" : "reference"));
}

bool answers_by_solution(const bsdf::Model& model) {
    return model.info().can.parts && !model.makes_table();
}

BrdfRequest parse_brdf_request(const ModelOptions& model_options, std::uint64_t seed,
                               const std::string& part, const std::string& at,
                               const std::string& footprint) {
    BrdfRequest request{parse_model_settings(model_options, seed), model_options.model_given,
                        parse_part<solver::Part>(part), at, footprint};
    const bsdf::ModelInfo& model = request.model.info();
    check_patch(request);
    require_values(model);
    if (request.part != solver::Part::total && !model.can.parts) {
        throw UsageError(fmt::format(
            "--part = {}: only --model {} knows parts", part,
            fmt::join(models_that([](const bsdf::ModelInfo& m) { return m.can.parts; }), ", ")));
    }
    return request;
}

BrdfSource load_brdf(const std::filesystem::path& path, const BrdfRequest& request,
                     const std::optional<std::vector<double>>& wavelengths_nm,
                     const CommonOptions& options) {
    if (is_measured_brdf_file(path)) {
        refuse_model_of_measured(request.model_given, std::string(request.model.info().name),
                                 path.string());
        if (request.part != solver::Part::total) {
            throw UsageError(
                fmt::format("--part: {} holds a measured BRDF, which has no parts", path.string()));
        }
        BrdfRequest as_measured = request;
        // Whatever the default of the command.
        if (request.model.info().name != models::default_model().info().name) {
            as_measured.model = models::default_model();
        }
        BrdfSource source = model_source(path, as_measured, wavelengths_nm, options);
        source.measured = true;
        return source;
    }
    if (answers_by_solution(request.model) && !is_brdf_table(path))
        return solved_source(path, request, wavelengths_nm, options);
    if (request.part != solver::Part::total) {
        throw UsageError(
            fmt::format("--part: {} holds a table, which does not know parts", path.string()));
    }
    return model_source(path, request, wavelengths_nm, options);
}

}  // namespace nacre::cli
