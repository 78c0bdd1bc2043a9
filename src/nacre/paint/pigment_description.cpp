#include <fmt/format.h>

#include "nacre/optics/particles.h"
#include "nacre/paint/limits.h"
#include "nacre/paint/recipe_description.h"

// Pigments: by their coefficients, their particles, or the constants of Kubelka and Munk.

namespace nacre::paint {

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
           .range = limits::kCoefficient,
           .typical = 10,
           .meaning = "scattering coefficient",
           .phrase = "scatters {}"},
          pigment.scattering_per_mm);
    visit({.key = "absorption_per_mm",
           .range = limits::kCoefficient,
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
           .range = limits::kCoefficient,
           .typical = 10,
           .meaning = "absorption",
           .required = true,
           .phrase = "K = {}"},
          constants.absorption_per_mm);
    visit({.key = "S",
           .range = limits::kCoefficient,
           .typical = 10,
           .meaning = "scattering",
           .required = true,
           .phrase = "S = {}"},
          constants.scattering_per_mm);
}

}  // namespace nacre::paint
