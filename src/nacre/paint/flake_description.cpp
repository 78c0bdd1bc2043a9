#include "nacre/optics/thin_film.h"
#include "nacre/paint/flake_sizes.h"
#include "nacre/paint/limits.h"
#include "nacre/paint/recipe_description.h"

// Flakes: how many, how large, how they lie, and what they are made of.

namespace nacre::paint {

namespace {

constexpr Range kFlakeDiameter{1e-3, 1e4, "um"};

constexpr Field kVolumeFraction{
    .key = "volume_fraction",
    .range = {0, 1, "", true},
    .typical = 0.03,
    .meaning =
        "fraction of the layer's volume that these flakes fill; all species of a layer "
        "together at most 1",
    .required = true,
    .phrase = "{%} by volume"};
// A data sheet tells it as the area of the flakes over the area painted.
constexpr Field kAreaDensity{.key = "area_density_per_um",
                             .range = {0, 1e6, "1/um", true},
                             .typical = 0.1,
                             .meaning = "in place of `volume_fraction`: flake area per volume, c",
                             .required = true};

}  // namespace

void describe(Visitor& visit, VolumeFraction& amount) { visit(kVolumeFraction, amount.value); }
void describe(Visitor& visit, AreaDensity& amount) { visit(kAreaDensity, amount.per_um); }

void describe(Visitor& visit, FlakeSpecies& species) {
    visit({.key = "name", .max_size = kMaxNameLength}, species.name);
    visit({.each = {{kVolumeFraction.key}, {kAreaDensity.key}},
           .both = "how many flakes there are is said twice; give volume_fraction or "
                   "area_density_per_um, not both",
           .neither = "is missing; it must be " + allowed_text(kVolumeFraction) +
                      ", or area_density_per_um in " + kAreaDensity.range.text()},
          species.amount);
    constexpr const char* kMean = "diameter_um";
    constexpr const char* kSpread = "diameter_spread_um";
    const bool plain = visit.instead(
        {.each = {{kMean, "goes with d50_um; these flakes have a diameter_um"},
                  {"d50_um", "with d10_um, d50_um and d90_um the sizes are said already"}},
         .both = "how large the flakes are is said twice; give diameter_um or d50_um, not both"},
        [] {
            return std::vector<std::string>{kMean, kSpread};
        },
        species.quantiles);
    if (plain) {
        visit({.key = kMean,
               .range = kFlakeDiameter,
               .typical = 18,
               .meaning = "of the disc; matters only where single flakes show",
               .phrase = "{} across"},
              species.diameter_um);
        visit({.key = kSpread,
               .range = {0, 1e4, "um"},
               .typical = 5,
               .meaning = "its standard deviation",
               .also = "at most `diameter_um`",
               .spread_of = kMean},
              species.diameter_spread_um);
    }
    visit({.key = "edge_um",
           .range = {1e-3, 100, "um"},
           .typical = 0.5,
           .meaning = "width of the rim that scatters light in all directions",
           .zero = "none",
           .phrase = "their outer {} scattering",
           .zero_phrase = "",
           .omit_default = true},
          species.edge_um);
    visit({.key = "waviness",
           .range = {0.001, 0.5},
           .typical = 0.02,
           .meaning = "of a flake's surface, as `alpha` of its slopes about the flake's plane; at "
                      "most twice the `alpha` of the planes",
           .zero = "flat",
           .phrase = "wavy (roughness {})",
           .zero_phrase = "",
           .omit_default = true},
          species.waviness);
    visit.table(
        {.key = "orientation", .meaning = "how the flakes lie", .required = true, .in_line = true},
        Described(species.orientation));
    visit({.each = {{"core", "goes with reflectance; a flake with a core gets it from its films"},
                    {"reflectance", "only with a core; this flake has a reflectance"}},
           .both = "a flake has either a reflectance or a core, not both"},
          species.body);
}

namespace {

Field quantile_field(const char* key, double typical_um, const char* meaning, const char* phrase) {
    return {.key = key,
            .range = kFlakeDiameter,
            .typical = typical_um,
            .meaning = meaning,
            .required = true,
            .also = "d10 < d50 < d90",
            .phrase = phrase};
}

Field d50_field(const char* phrase) {
    return quantile_field("d50_um", 18,
                          "in place of `diameter_um`: half of the volume, as makers state it by "
                          "laser diffraction",
                          phrase);
}

}  // namespace

void describe(Visitor& visit, StatedQuantiles& quantiles) {
    visit({.each = {{"", "goes with d10_um; give both, or d50_um alone for a typical pigment"},
                    {"d10_um"}},
           .both = ""},
          quantiles);
}

void describe(Visitor& visit, MedianDiameter& median) {
    static_assert(kTypicalDecileRatio == 2, "is said in words here and below");
    visit(d50_field("half of their volume below {}, a tenth below half and nine tenths below twice "
                    "that (typical)"),
          median.d50_um);
}

void describe(Visitor& visit, DiameterQuantiles& quantiles) {
    Field d10 = quantile_field("d10_um", 8,
                               "a tenth of the powder's volume is in flakes smaller than this; "
                               "with `d90_um`",
                               "a tenth of their volume below {}");
    d10.otherwise = "`d50_um` / 2";
    Field d90 = quantile_field("d90_um", 32, "nine tenths of the volume; with `d10_um`",
                               "nine tenths below {}");
    d90.otherwise = "2 `d50_um`";
    visit(d10, quantiles.d10_um);
    visit(d50_field("half below {}"), quantiles.d50_um);
    visit(d90, quantiles.d90_um);
}

void describe(Visitor& visit, Orientation& orientation) {
    visit({.key = "distribution",
           .meaning = "law of the flakes' normals: Gaussian slopes, GGX, or a table",
           .required = true},
          {"beckmann", "ggx", "tabulated"}, orientation.law);
    const bool by_alpha = visit.instead(
        {.each = {{"alpha", "goes with distribution = \"tabulated\"; this one has an alpha"},
                  {"tilts", "the law of the normals is said by tilts already"}},
         .both = "the law of the normals is said twice; give alpha or tilts, not both",
         .neither = "is missing; it must be a number in " + limits::kOrientationAlpha.text() +
                    ", or tilts where the law is tabulated"},
        [] {
            return std::vector<std::string>{"alpha", "alpha_bottom"};
        },
        orientation.table);
    if (!by_alpha) return;
    // A data sheet tells both as the median tilt.
    visit({.key = "alpha",
           .range = limits::kOrientationAlpha,
           .typical = 0.1,
           .meaning = "sqrt(2) times the standard deviation of a slope component: 0.1 is 4 deg; of "
                      "`ggx` its own, in [0.02, 0.5]",
           .required = true},
          orientation.beckmann_alpha);
    visit({.key = "alpha_bottom",
           .range = limits::kOrientationAlpha,
           .typical = 0.1,
           .meaning = "`alpha` at the bottom of the layer, linear in depth from the top",
           .zero = "the same at all depths",
           .omit_default = true},
          orientation.alpha_bottom);
}

void describe(Visitor& visit, TabulatedTilts& table) {
    visit({.key = "tilts",
           .meaning = "with `tabulated`: the law at two tilts or more, linear between them",
           .max_size = 1000,
           .in_line = true},
          table.tilts);
}

void describe(Visitor& visit, TiltDensity& point) {
    visit({.key = "tilt_deg",
           .range = {0, 90, "deg"},
           .typical = 0,
           .meaning = "between the normals of flake and paint, increasing",
           .required = true},
          point.tilt_deg);
    visit({.key = "density",
           .range = {0, 1e9},
           .typical = 1,
           .meaning = "area of the flakes per degree of tilt, in any unit",
           .required = true},
          point.density);
}

void describe(Visitor& visit, optics::Platelet& platelet) {
    visit.table({.key = "core",
                 .meaning = "the platelet, a film (below)",
                 .required = true,
                 .phrase = "{}",
                 .in_line = true},
                Described(platelet.core));
    visit(
        {.key = "coats",
         .meaning = "films from the core outwards",
         .phrase = platelet.coated_sides == optics::Platelet::CoatedSides::both ? "on both sides {}"
                                                                                : "on one side {}",
         .max_size = 64,
         .in_line = true},
        platelet.coats);
    visit({.key = "coated_sides",
           .meaning = "whether both sides have the coats, alike, or one",
           .phrase = "",
           .zero_phrase = "",
           .omit_default = true},
          {"both", "one"}, platelet.coated_sides);
}

void describe(Visitor& visit, optics::FilmPopulation& film) {
    visit({.key = "material",
           .range = optics::kRefractiveIndexRange,
           .meaning = "see below",
           .required = true,
           .phrase = "{}"},
          film.material);
    visit({.key = "thickness_nm",
           .range = limits::kFilmThickness,
           .typical = 100,
           .meaning = "mean thickness",
           .required = true,
           .phrase = "{}"},
          film.thickness_nm);
    visit({.key = "spread_nm",
           .range = limits::kFilmSpread,
           .typical = 5,
           .meaning = "standard deviation from flake to flake",
           .spread_of = "thickness_nm"},
          film.spread.standard_deviation_nm);
    visit({.key = "distribution",
           .meaning = "law of the thickness; normal is cut off at three deviations and at zero, "
                      "and renormalised; uniform has the same standard deviation",
           .phrase = "uniformly spread",
           .zero_phrase = ""},
          {"normal", "uniform"}, film.spread.law);
}

void describe(Visitor& visit, PrescribedFlake& flake) {
    visit({.key = "reflectance",
           .range = limits::kFraction,
           .typical = 0.5,
           .meaning = "in place of `core` and `coats`: R, the same at all angles",
           .required = true,
           .phrase = "reflects {%}",
           .colour = true},
          flake.reflectance);
    visit({.key = "transmittance",
           .range = limits::kFraction,
           .typical = 0.1,
           .meaning = "with `reflectance` only",
           .also = "R + T <= 1",
           .phrase = "transmits {%}",
           .colour = true},
          flake.transmittance);
    // A data sheet tells it as the thickness of the flakes, which those with a core have too.
    visit({.key = "thickness_um",
           .range = {0, 1e3, "um", true},
           .typical = 0.3,
           .meaning = "with `reflectance` only; required with `volume_fraction`",
           .required_with = kVolumeFraction.key},
          flake.thickness_um);
}

}  // namespace nacre::paint
