#include "nacre/paint/recipe_description.h"

#include <fmt/format.h>

#include "nacre/optics/airy.h"

namespace nacre::paint {

namespace {

constexpr std::size_t kMaxNameLength = 200;
constexpr std::size_t kMaxPathLength = 2000;
constexpr std::size_t kMaxSpeciesPerLayer = 64;  // of flakes, and as many pigments

constexpr Range kPerMillimetre{0, 1e9, "1/mm"};
constexpr Range kFraction{0, 1};
constexpr Range kFlakeDiameter{1e-3, 1e4, "um"};

}  // namespace

// Ranges are wide: they keep out slips of a decimal point and numbers on which arithmetic would
// fail, not unusual paints.

void describe(Visitor& visit, Recipe& recipe) {
    visit({.key = "name",
           .meaning = "what people call it",
           .phrase = "",  // the title of the sheet
           .max_size = kMaxNameLength},
          recipe.name);
    visit({.key = "ior",
           .range = limits::kBinderIndex,
           .meaning = "refractive index of binder and clearcoat",
           .required = true,
           .phrase = "The binder has {}",
           .real = true},
          recipe.binder);
    visit({.key = "lean",
           .meaning = "mean normal of all flakes, where they lean towards one side "
                      "([flakes.md](flakes.md#leaning-flakes)); without it, or with a tilt of 0, "
                      "that of the paint",
           .phrase = "All flakes lean {}",
           .in_line = true},
          recipe.lean);
    visit({.key = "clearcoat", .meaning = "a clear layer on top; without it the air meets layer 1"},
          recipe.clearcoat);
    visit({.key = "layer",
           .meaning = "the layers, from the top down; at least one, or a `microfacet`",
           .max_size = limits::kMaxLayers},
          recipe.layers);
    Substrate substrate{recipe.substrate_reflectance};
    visit.table({.key = "substrate",
                 .meaning = "what lies below, a Lambertian surface inside the binder",
                 .otherwise = "black",
                 .phrase = "{}"},
                Described(substrate));
    visit({.key = "microfacet", .meaning = "another description, for the microfacet models"},
          recipe.microfacet);
    visit.beside({.key = "fit", .meaning = "bounds for [fitting](fit.md); no part of the paint"});
    visit.beside({.key = "uncertainty",
                  .meaning = "how well numbers are [known](uncertainty.md); no part of the paint"});
}

void describe(Visitor& visit, Clearcoat& coat) {
    visit({.key = "thickness_um",
           .range = {0, 1e6, "um"},
           .typical = 45,
           .required = true,
           .phrase = "{}"},
          coat.thickness_um);
    visit({.key = "thickness_spread_um",
           .range = {0, 1e6, "um"},
           .typical = 3,
           .meaning = "standard deviation of the thickness over a panel, which only pictures show "
                      "([coat-thickness.md](coat-thickness.md))",
           .also = "at most a third of `thickness_um`",
           .spread_of = "thickness_um",
           .omit_default = true},
          coat.thickness_spread_um);
    visit({.key = "absorption_per_mm",
           .range = kPerMillimetre,
           .typical = 10,
           .meaning = "absorption coefficient, for tinted clear coats",
           .phrase = "absorbs {}",
           .zero_phrase = "clear"},
          coat.absorption_per_mm);
    // Below 0.01 the reflected lobe is narrower than about 1 deg, and a smooth interface is the
    // better model: it is solved faster and to more digits, and the walks of montecarlo/ need some
    // 1 / alpha^2 trials under a rough one.
    visit({.key = "roughness",
           .range = {0.01, 1},
           .typical = 0.1,
           .meaning = "Beckmann alpha of the air interface; 0 is smooth, a mirror",
           .zero = "a smooth interface",
           .phrase = "matte surface (roughness {})",
           .zero_phrase = "smooth surface"},
          coat.roughness);
    visit({.key = "orange_peel",
           .meaning = "waves of the air interface, which only pictures and `nacre sparkle` show "
                      "([orange-peel.md](orange-peel.md))",
           .phrase = "orange peel with slopes of {}",
           .in_line = true},
          coat.orange_peel);
}

void describe(Visitor& visit, OrangePeel& peel) {
    // All bands together stay below 0.22: a facet is tilted by 13 deg at the most typical.
    constexpr Range kSlope{0, 0.1};
    visit({.key = "wa",
           .range = kSlope,
           .meaning = "root mean square slope along a line of the waves of 0.1 to 0.3 mm",
           .phrase = "{} (0.1 to 0.3 mm)",
           .zero_phrase = ""},
          peel.wa);
    visit({.key = "wb",
           .range = kSlope,
           .meaning = "the same of 0.3 to 1 mm",
           .phrase = "{} (0.3 to 1 mm)",
           .zero_phrase = ""},
          peel.wb);
    visit({.key = "wc",
           .range = kSlope,
           .meaning = "of 1 to 3 mm",
           .phrase = "{} (1 to 3 mm)",
           .zero_phrase = ""},
          peel.wc);
    visit({.key = "wd",
           .range = kSlope,
           .meaning = "of 3 to 10 mm",
           .phrase = "{} (3 to 10 mm)",
           .zero_phrase = ""},
          peel.wd);
    visit({.key = "we",
           .range = kSlope,
           .meaning = "of 10 to 30 mm",
           .phrase = "{} (10 to 30 mm)",
           .zero_phrase = ""},
          peel.we);
}

void describe(Visitor& visit, FlakeLean& lean) {
    visit(
        {.key = "tilt_deg",
         .range = limits::kLeanTilt,
         .typical = 5,
         .meaning = "between the mean normal of the flakes and the normal of the paint; only with "
                    "`roughness` 0",
         .required = true,
         .phrase = "by {}"},
        lean.tilt_deg);
    visit({.key = "azimuth_deg",
           .range = {-360, 360, "deg"},
           .meaning = "of the side towards which the flakes' upper faces look: 0 is the lamp's in "
                      "readings, x of the shape in pictures",
           .phrase = "towards {}",
           .zero_phrase = "towards the lamp of readings"},
          lean.azimuth_deg);
}

void describe(Visitor& visit, Layer& layer) {
    visit({.key = "thickness_um",
           .range = {0, 1e6, "um", true},
           .typical = 15,
           .required = true,
           .phrase = "{}"},
          layer.thickness_um);
    visit({.key = "flakes", .meaning = "species of flakes", .max_size = kMaxSpeciesPerLayer},
          layer.flakes);
    visit({.key = "pigment",
           .meaning = "pigments that scatter in all directions",
           .max_size = kMaxSpeciesPerLayer},
          layer.pigments);
}

namespace {

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
           .range = kFraction,
           .typical = 0.5,
           .meaning = "in place of `core` and `coats`: R, the same at all angles",
           .required = true,
           .phrase = "reflects {%}",
           .colour = true},
          flake.reflectance);
    visit({.key = "transmittance",
           .range = kFraction,
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

namespace {

constexpr const char* kVolumeKey = "volume_fraction";
constexpr const char* kMassKey = "mass_fraction";
constexpr Range kMassFraction{0, 1, "", true, true};
constexpr const char* kAmountTwice =
    "how much pigment there is is said twice; give volume_fraction or mass_fraction, not both";

constexpr Field kAnisotropy{.key = "anisotropy",
                            .range = {-1, 1, "", true, true},
                            .meaning =
                                "g, the mean cosine of the angle by which light is turned "
                                "[henyey-greenstein-1941]; models that solve the paint take "
                                "[-0.97, 0.97]",
                            .phrase = "g = {}"};

void describe_amount(Visitor& visit, OptionalPigmentAmount& amount) {
    visit(
        {.each = {{"", "goes with mass_fraction"}, {kVolumeKey}, {kMassKey}}, .both = kAmountTwice},
        amount);
}

}  // namespace

void describe(Visitor& visit, Pigment& pigment) {
    visit.preset({.key = "from",
                  .meaning = "a pigment that ships (`nacre pigments`), or the path of a file that "
                             "`nacre pigment` wrote, whose keys stand for those here; only the "
                             "amount and a name stand beside",
                  .max_size = kMaxPathLength});
    visit({.key = "name", .max_size = kMaxNameLength}, pigment.name);
    visit({.each = {{"scattering_per_mm", "goes with a material; this pigment has coefficients"},
                    {"material",
                     "a pigment with a material gets its coefficients from its particles"},
                    {"kubelka_munk", "a pigment with kubelka_munk gets its coefficients from it"}},
           .both = "a pigment has either coefficients, or a material, or kubelka_munk"},
          pigment.body);
}

std::string amount_is_missing() {
    return fmt::format("is missing; it must be a number in {}, or {} in {}",
                       optics::kParticleVolumeRange.text(), kMassKey, kMassFraction.text());
}

void describe(Visitor& visit, PigmentParticles& particles) {
    optics::Spheres& spheres = particles.spheres;
    visit({.key = "material",
           .range = optics::kRefractiveIndexRange,
           .meaning = "in place of coefficients: what the particles are made of, spheres by Mie's "
                      "series [bohren-huffman-1983]",
           .required = true,
           .phrase = "{}"},
          spheres.material);
    visit(
        {.each = {{kVolumeKey}, {kMassKey}}, .both = kAmountTwice, .neither = amount_is_missing()},
        particles.amount);
    visit({.key = "diameter_nm",
           .range = optics::kDiameterRange,
           .typical = 250,
           .meaning = "median diameter of the particles",
           .required = true,
           .phrase = "{} across"},
          spheres.diameter_nm);
    visit({.key = "spread",
           .range = optics::kDiameterSpreadRange,
           .meaning = "standard deviation of the logarithm of the diameter, which has a normal law "
                      "cut at five deviations; 0 is one size",
           .phrase = "log-normal with a deviation of {} in the logarithm",
           .zero_phrase = "all of one size"},
          spheres.spread);
    visit({.key = "weighting",
           .meaning = "what the median halves: the number of particles, or their volume",
           .phrase = "median by {}"},
          {"number", "volume"}, spheres.weighting);
    visit(
        {.key = "crowding",
         .meaning = "whether particles keep apart as hard spheres do, which takes light out of "
                    "the forward lobe [percus-yevick-1958; pedersen-1994], or scatter as if alone",
         .phrase = "",
         .zero_phrase = ""},
        {"hard-spheres", "independent"}, spheres.crowding);
}

void describe(Visitor&, PigmentUnstated&) {}

void describe(Visitor& visit, PigmentVolume& amount) {
    visit({.key = kVolumeKey,
           .range = optics::kParticleVolumeRange,
           .typical = 0.03,
           .meaning = "fraction of the layer's volume that the pigment fills, all pigments of a "
                      "layer together at most 0.5; required with `material` and `from`; "
                      "coefficients are those of a volume fraction of 1 where it is given, else "
                      "the layer's",
           .required = true,
           .phrase = "{%} by volume"},
          amount.fraction);
}

void describe(Visitor& visit, PigmentMass& amount) {
    constexpr Range kDensity{0.1, 25, "g/cm^3"};
    visit({.key = kMassKey,
           .range = kMassFraction,
           .typical = 0.05,
           .meaning = "in place of `volume_fraction`: fraction of the dry layer's mass",
           .required = true,
           .phrase = "{%} by mass"},
          amount.fraction);
    visit({.key = "density_g_per_cm3",
           .range = kDensity,
           .typical = 3,
           .meaning = "with `mass_fraction`: of the pigment",
           .required = true,
           .phrase = ""},
          amount.density_g_per_cm3);
    visit({.key = "binder_density_g_per_cm3",
           .range = kDensity,
           .meaning = "with `mass_fraction`: of all the rest",
           .phrase = ""},
          amount.binder_density_g_per_cm3);
}

void describe(Visitor& visit, PigmentCoefficients& pigment) {
    visit({.key = "scattering_per_mm",
           .range = kPerMillimetre,
           .typical = 10,
           .meaning = "scattering coefficient",
           .phrase = "scatters {}"},
          pigment.scattering_per_mm);
    visit({.key = "absorption_per_mm",
           .range = kPerMillimetre,
           .typical = 10,
           .meaning = "absorption coefficient",
           .phrase = "absorbs {}"},
          pigment.absorption_per_mm);
    visit(kAnisotropy, pigment.anisotropy);
    describe_amount(visit, pigment.amount);
}

void describe(Visitor& visit, PigmentKubelkaMunk& pigment) {
    visit.table({.key = "kubelka_munk",
                 .meaning = "in place of coefficients: the constants of Kubelka and Munk "
                            "[kubelka-munk-1931], `{ K = spectrum, S = spectrum }` in 1/mm, each "
                            "in [0, 1e9]; K = 2 sigma_a, S = 3/4 (1 - g) sigma_s",
                 .required = true,
                 .phrase = "{}",
                 .in_line = true},
                Described(pigment.constants));
    visit(kAnisotropy, pigment.anisotropy);
    describe_amount(visit, pigment.amount);
}

void describe(Visitor& visit, KubelkaMunk& constants) {
    visit({.key = "K",
           .range = kPerMillimetre,
           .typical = 10,
           .meaning = "absorption",
           .required = true,
           .phrase = "K = {}"},
          constants.absorption_per_mm);
    visit({.key = "S",
           .range = kPerMillimetre,
           .typical = 10,
           .meaning = "scattering",
           .required = true,
           .phrase = "S = {}"},
          constants.scattering_per_mm);
}

void describe(Visitor& visit, Substrate& substrate) {
    visit({.key = "reflectance",
           .range = kFraction,
           .typical = 0.05,
           .meaning = "of the surface under the last layer",
           .required = true,
           .phrase = "reflects {%}",
           .colour = true},
          substrate.reflectance);
}

void describe(Visitor& visit, Microfacet& m) {
    // Below the range of alpha directions in single precision do not resolve the slopes.
    visit({.key = "alpha",
           .range = limits::kMicrofacetAlpha,
           .typical = 0.1,
           .meaning = "roughness",
           .required = true,
           .phrase = "roughness {}"},
          m.alpha);
    visit({.key = "distribution",
           .meaning = "law of the facets' normals",
           .phrase = "GGX",
           .zero_phrase = "Beckmann"},
          {"beckmann", "ggx"}, m.distribution);
    visit({.key = "film_ior",
           .range = optics::kAiryIndexRange,
           .typical = 1.8,
           .meaning = "index of the film, eta_2",
           .required = true,
           .phrase = "with n = {}"},
          m.film_ior);
    visit({.key = "film_thickness_nm",
           .range = {0, 1e5, "nm"},
           .typical = 150,
           .meaning = "thickness d; the paper's P_inc is 2 eta_2 d",
           .required = true,
           .phrase = "a film of {}"},
          m.film_thickness_nm);
    visit({.key = "base_ior",
           .range = optics::kAiryIndexRange,
           .typical = 1.08,
           .meaning = "n of the base, eta_3",
           .required = true,
           .phrase = "on a base with n = {}"},
          m.base_ior);
    visit({.key = "base_extinction",
           .range = optics::kAiryExtinctionRange,
           .typical = 0.5,
           .meaning = "k of the base, kappa_3: k itself, not k / n",
           .phrase = "k = {}",
           .zero_phrase = ""},
          m.base_extinction);
    visit({.key = "facets", .meaning = "for models that show single facets"}, m.facets);
}

void describe(Visitor& visit, MicrofacetFacets& facets) {
    visit({.key = "count",
           .range = {1, 1e15},
           .typical = 1e7,
           .meaning = "K, over the whole object",
           .required = true,
           .phrase = "{} facets over the whole object"},
          facets.count);
    visit({.key = "cone_deg",
           .range = {0.05, 30, "deg"},
           .typical = 3,
           .meaning = "gamma, half-angle of the query cone",
           .required = true,
           .phrase = "each seen within {} of its mirror direction"},
          facets.cone_deg);
    visit({.key = "thickness_spread_nm",
           .range = limits::kFilmSpread,
           .meaning = "standard deviation of d",
           .phrase = "their films varying by {}"},
          facets.thickness_spread_nm);
}

}  // namespace nacre::paint
