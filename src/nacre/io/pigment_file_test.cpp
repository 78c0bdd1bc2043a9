#include "nacre/io/pigment_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nacre/core/error.h"
#include "nacre/io/recipe_file.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/files.h"

namespace nacre::io {
namespace {

using nacre::test::message_of;
using ::testing::HasSubstr;
using ::testing::Not;

std::string recipe_with(const std::string& pigment) {
    return "ior = 1.5\n[[layer]]\nthickness_um = 20\n[[layer.pigment]]\n" + pigment;
}

paint::Pigment pigment_of(const std::string& text, const References& references = {}) {
    return parse_recipe(recipe_with(text), "paint.toml", references).layers[0].pigments[0];
}

std::string refusal(const std::string& text, const References& references = {}) {
    return message_of<InputError>([&] { pigment_of(text, references); });
}

TEST(PigmentFile, EachThatShipsIsRightAndSaysItsSource) {
    ASSERT_FALSE(shipped_pigments().empty());
    for (const ShippedPigment& shipped : shipped_pigments()) {
        const PigmentFile file = parse_pigment_file(shipped.toml, std::string(shipped.name), 0.1);
        EXPECT_FALSE(file.pigment.name.empty()) << shipped.name;
        EXPECT_GT(file.source.size(), 20u) << shipped.name;
        ASSERT_TRUE(file.pigment.amount());
        EXPECT_EQ(volume_fraction(*file.pigment.amount()), 0.1);
    }
}

TEST(PigmentFile, ARecipeNamesOneThatShips) {
    const paint::Pigment white = pigment_of("from = \"rutile-white\"\nvolume_fraction = 0.2\n");
    EXPECT_EQ(white.name, "rutile white");
    const auto& particles = std::get<paint::PigmentParticles>(white.body);
    EXPECT_EQ(particles.spheres.diameter_nm, 280);
    EXPECT_EQ(volume_fraction(particles.amount), 0.2);
    // By mass, and under another name.
    const paint::Pigment mass = pigment_of(
        "from = \"rutile-white\"\nname = \"R\"\nmass_fraction = 0.5\ndensity_g_per_cm3 = 4.2\n");
    EXPECT_EQ(mass.name, "R");
    EXPECT_NEAR(volume_fraction(*mass.amount()), 0.5 / 4.2 / (0.5 / 4.2 + 0.5 / 1.1), 1e-12);
}

TEST(PigmentFile, CoefficientsAreThoseOfAVolumeFractionOfOne) {
    const nacre::test::TempFolder folder;
    const PigmentFile blue{
        {paint::PigmentCoefficients{spectra::Spectrum({400, 700}, {300, 200}), 4000.0, 0.25},
         "blue"},
        "a test"};
    folder.write("blue.toml", write_pigment_file(blue));
    const paint::Pigment read =
        pigment_of("from = \"blue.toml\"\nvolume_fraction = 0.05\n", folder.path());
    EXPECT_EQ(read.name, "blue");
    const paint::PigmentCoefficients layer = *read.layer_coefficients();
    EXPECT_DOUBLE_EQ(layer.scattering_per_mm(400), 15);
    EXPECT_DOUBLE_EQ(layer.absorption_per_mm(550), 200);
    EXPECT_EQ(layer.anisotropy, 0.25);
    // What a recipe writes reads back without the file.
    const paint::Recipe recipe = parse_recipe(
        recipe_with("from = \"blue.toml\"\nvolume_fraction = 0.05\n"), "paint.toml", folder.path());
    EXPECT_EQ(parse_recipe(write_recipe(recipe), "again.toml", {}), recipe);
}

TEST(PigmentFile, KubelkaMunkConstantsBecomeCoefficients) {
    const paint::Pigment pigment =
        pigment_of("kubelka_munk = { K = 8, S = 6 }\nanisotropy = 0.5\nvolume_fraction = 0.1\n");
    const paint::PigmentCoefficients layer = *pigment.layer_coefficients();
    EXPECT_DOUBLE_EQ(layer.absorption_per_mm(550), 0.4);                    // K / 2
    EXPECT_DOUBLE_EQ(layer.scattering_per_mm(550), 0.1 * 6 * 4 / 3 / 0.5);  // S = 3/4 (1 - g) s
    EXPECT_THAT(refusal("kubelka_munk = { K = -1, S = 6 }\n"),
                HasSubstr("layer[0].pigment[0].kubelka_munk.K = -1: must be a number in"));
    EXPECT_THAT(refusal("kubelka_munk = { K = 1, S = 6 }\nscattering_per_mm = 3\n"),
                HasSubstr("either coefficients, or a material, or kubelka_munk"));
}

TEST(PigmentFile, CoefficientsWithoutAnAmountAreThoseOfTheLayer) {
    const paint::Pigment pigment = pigment_of("absorption_per_mm = 8\n");
    EXPECT_FALSE(pigment.amount());
    EXPECT_EQ(pigment.layer_coefficients()->absorption_per_mm, spectra::Spectrum(8));
    EXPECT_THAT(refusal("absorption_per_mm = 8\ndensity_g_per_cm3 = 2\n"),
                HasSubstr("goes with mass_fraction"));
}

TEST(PigmentFile, ComplaintsNameWhatIsWrongAndWhere) {
    EXPECT_THAT(refusal("from = \"rutil-white\"\nvolume_fraction = 0.1\n"),
                HasSubstr("(did you mean 'rutile-white'?)"));
    EXPECT_THAT(refusal("from = \"rutile-white\"\n"),
                HasSubstr("layer[0].pigment[0].volume_fraction: is missing"));
    EXPECT_THAT(refusal("from = \"rutile-white\"\nvolume_fraction = 0.1\nspread = 0.3\n"),
                HasSubstr("paint.toml:7:"));
    EXPECT_THAT(refusal("from = \"rutile-white\"\nvolume_fraction = 0.7\n"),
                HasSubstr("must be a number in (0, 0.5]"));
    EXPECT_THAT(refusal("from = \"../etc/blue.toml\"\nvolume_fraction = 0.1\n"),
                HasSubstr("layer[0].pigment[0].from"));

    const nacre::test::TempFolder folder;
    folder.write("bad.toml", "scattering_per_mm = -3\nsecret = \"word\"\n");
    const std::string bad = refusal("from = \"bad.toml\"\nvolume_fraction = 0.1\n", folder.path());
    EXPECT_THAT(bad, HasSubstr("bad.toml:2"));
    EXPECT_THAT(bad, Not(HasSubstr("word")));  // a file that another names is not quoted
    folder.write("loop.toml", "from = \"loop.toml\"\n");
    EXPECT_THAT(refusal("from = \"loop.toml\"\nvolume_fraction = 0.1\n", folder.path()),
                HasSubstr("loop.toml:1"));
}

}  // namespace
}  // namespace nacre::io
