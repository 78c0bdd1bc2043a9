#include "nacre/paint/recipe_description.h"

#include "nacre/optics/airy.h"
#include "nacre/paint/limits.h"

// The layers of a recipe, from the top down, and its microfacets. Ranges are wide, here and in the
// descriptions of flakes and pigments: they keep out slips of a decimal point and numbers on which
// arithmetic would fail, not unusual paints.

namespace nacre::paint {

namespace {

constexpr std::size_t kMaxSpeciesPerLayer = 64;  // of flakes, and as many pigments

}  // namespace

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
           .range = limits::kCoefficient,
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

void describe(Visitor& visit, Substrate& substrate) {
    visit({.key = "reflectance",
           .range = limits::kFraction,
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
