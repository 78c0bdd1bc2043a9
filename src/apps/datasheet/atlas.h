#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/core/progress.h"
#include "nacre/measure/measurement.h"
#include "nacre/optics/thin_film.h"
#include "nacre/paint/recipe.h"
#include "nacre/solver/solver.h"

// Numbers and conditions in words.

namespace nacre::datasheet {

/// "45°", "−15°", with the minus sign of typography.
std::string degrees_text(double angle_deg);

/// A number with so many decimals and the minus sign of typography.
std::string decimal_text(double value, int decimals);

/// "illuminant D65, 10° observer, point apertures".
std::string conditions_text(const measure::Conditions& conditions);

// Which thickness of a film has which colour at which angle: the map from which interference
// pigments are chosen. docs/panel.md has the definitions.

/// At most so many thicknesses times geometries.
inline constexpr std::size_t kMaxAtlasCells = 100'000;

struct Atlas {
    std::string title = {};     ///< "TiO2_anatase on mica"
    std::string quantity = {};  ///< what runs across: "thickness of TiO2_anatase, nm"
    std::string column = {};    ///< the same as a CSV heading: "thickness_nm"
    std::string caption = {};   ///< what the chips are
    measure::Conditions conditions = {};
    std::vector<double> values = {};                 ///< across
    std::vector<measure::Geometry> geometries = {};  ///< down
    std::vector<Vec3d> lab = {};                     ///< [geometry][value], row-major

    const Vec3d& at(std::size_t geometry, std::size_t value) const {
        return lab[geometry * values.size() + value];
    }
};

/// A flake with one film whose thickness varies.
struct AtlasFlake {
    std::optional<optics::FilmPopulation> core = {};  ///< none: the film is the flake
    optics::Material film = {};
    optics::ThicknessSpread film_spread = {};
    std::vector<optics::FilmPopulation> outer = {};  ///< coats over the film, outwards
    optics::Material binder = optics::Material(1.5);
};

/// Cosine of the angle on a flake that mirrors the lamp into the view, both refracted at the flat
/// surface of a binder: its normal is the half vector inside (docs/panel.md).
/// @param binder_index  real, >= 1
double cos_on_flake(const measure::Geometry& geometry, double binder_index);

/// What single flakes show: the reflectance of the flake at cos_on_flake() as a reflectance factor.
/// A layer of such flakes has this times a factor of position that hardly depends on the
/// wavelength, so that hues are those of the paint; its lightness is relative.
///
/// @param wavelengths_nm  at least two, in equal steps
/// @param progress  asked after each thickness
/// @throws DomainError naming what is out of range, or as optics::platelet_table()
/// @throws Error if `progress` asks to stop
Atlas flake_atlas(const AtlasFlake& flake, const std::vector<double>& thickness_nm,
                  const std::vector<measure::Geometry>& geometries,
                  const std::vector<double>& wavelengths_nm,
                  const measure::Conditions& conditions = {}, const Progress& progress = {});

/// What an instrument reads on a recipe, at the geometries and under the conditions of an atlas.
using RecipeReader =
    std::function<measure::Measurement(const paint::Recipe&, const Progress& progress)>;

/// What the whole paint shows, with all its layers and scattering: the recipe solved anew for each
/// value of one of its numbers, read by an instrument with point apertures, without the specular
/// reflection of its surface.
///
/// @param key       as paint::find_parameter(): "layer[0].flakes[0].coats[0].thickness_nm"
/// @param progress  asked after each value
/// @param read      none: by the solved paint itself at `wavelengths_nm`
/// @throws DomainError as paint::set_parameter() and solver::solve(), Error likewise or if
///         `progress` asks to stop
Atlas recipe_atlas(const paint::Recipe& recipe, const std::string& key,
                   const std::vector<double>& values,
                   const std::vector<measure::Geometry>& geometries,
                   const std::vector<double>& wavelengths_nm,
                   const measure::Conditions& conditions = {}, const Progress& progress = {},
                   RecipeReader read = {});

/// The atlas as a grid of chips (measure::srgb_chip_at_full_light()), with what they stand for:
/// SVG 1.1 without scripts, as report::plot_svg().
std::string atlas_svg(const Atlas& atlas);

/// One line a chip: the value under the heading atlas.column, theta_i, aspecular_deg, L, a, b, C,
/// h, chip.
std::string atlas_csv(const Atlas& atlas);

}  // namespace nacre::datasheet
