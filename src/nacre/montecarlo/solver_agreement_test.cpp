#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "nacre/core/file.h"
#include "nacre/solver/solver.h"
#include "nacre/testing/montecarlo.h"
#include "nacre/testing/solver_agreement_walks.h"

// The solver against the random walk, over a grid of paints and angles: one z-score per value.

namespace nacre::montecarlo {
namespace {

struct Case {
    std::string name;
    paint::Recipe recipe;
    std::vector<double> wavelengths_nm = {550};
};

paint::FlakeSpecies titania_on_mica(double area_density_per_um, double alpha) {
    auto species = test::flakes(area_density_per_um, alpha, 0, 0);
    optics::Platelet body;
    body.core = {optics::Material(1.58), 500, {60, optics::ThicknessSpread::Law::normal}};
    body.coats = {{optics::Material(2.5), 110, {5, optics::ThicknessSpread::Law::normal}}};  // TiO2
    species.body = body;
    return species;
}

paint::PigmentParticles particles(const char* material, double volume, double diameter_nm,
                                  double spread) {
    return {
        paint::PigmentVolume{volume},
        {optics::find_material(material), diameter_nm, spread, optics::DiameterWeighting::volume}};
}

std::vector<Case> cases() {
    std::vector<Case> all;
    const auto add = [&](std::string name, paint::Recipe recipe) {
        all.push_back({std::move(name), std::move(recipe)});
    };
    // alpha, depth, binder
    add("alpha .05, beta 1.5", test::paint_of(1.5, {test::flake_layer(1.5, .05, .6, 0)}));
    add("alpha .1, beta .02", test::paint_of(1.5, {test::flake_layer(.02, .1, .9, 0)}));
    add("alpha .1, beta 20", test::paint_of(1.5, {test::flake_layer(20, .1, .6, 0)}));
    add("alpha .1, beta 1.5, n 1", test::paint_of(1, {test::flake_layer(1.5, .1, .6, 0)}));
    add("alpha .3, beta 2", test::paint_of(1.5, {test::flake_layer(2, .3, .8, .1)}));
    add("alpha .3, beta 2, n 1", test::paint_of(1, {test::flake_layer(2, .3, .8, .1)}));
    add("alpha .5, beta 5", test::paint_of(1.5, {test::flake_layer(5, .5, .7, 0)}));
    // lossless flakes that transmit, over white
    add("alpha .5, R + T = 1, white", test::paint_of(1.5, {test::flake_layer(2, .5, .4, .6)}, 1.0));
    add("alpha .1, R + T = 1, grey", test::paint_of(1.5, {test::flake_layer(1, .1, .3, .7)}, 0.4));
    // an absorbing clearcoat
    auto coated = test::paint_of(1.5, {test::flake_layer(1.5, .2, .8, 0)}, 0.2);
    coated.clearcoat = paint::Clearcoat{45, 6.0, 0};
    add("absorbing clearcoat", coated);
    // pigments
    add("pigment g 0", test::paint_of(1.5, {test::pigment_layer(.9, 2, 0)}, 0.3));
    add("pigment g .8", test::paint_of(1.5, {test::pigment_layer(.99, 8, .8)}));
    auto mixture = test::paint_of(1.5, {test::flake_layer(1, .2, .6, .1)}, 0.05);
    mixture.layers[0].pigments.push_back({paint::PigmentCoefficients{40.0, 20.0, 0.5}});
    mixture.layers[0].pigments.push_back({paint::PigmentCoefficients{10.0, 0.0, -0.3}});
    mixture.layers[0].flakes.push_back(test::flakes(.05, .4, .2, .3));
    add("two flakes, two pigments", mixture);
    add("flakes over pigment",
        test::paint_of(1.5, {test::flake_layer(.7, .1, .3, .6), test::pigment_layer(.8, 3, .3)},
                       0.1));
    // an interference pigment over black, colours
    paint::Layer pearl;
    pearl.thickness_um = 15;
    pearl.flakes.push_back(titania_on_mica(.12, .1));
    all.push_back({"TiO2 on mica", test::paint_of(1.5, {pearl}, 0.05), {450, 550, 650}});
    // the mixture in a spectrum, for the weights of eight wavelengths on one walk
    auto spectral = mixture;
    std::get<paint::PigmentCoefficients>(spectral.layers[0].pigments[0].body).scattering_per_mm =
        spectra::Spectrum({400, 700}, {120, 5});
    std::get<paint::PigmentCoefficients>(spectral.layers[0].pigments[0].body).absorption_per_mm =
        spectra::Spectrum({400, 700}, {2, 60});
    all.push_back({"mixture, three wavelengths", spectral, {400, 550, 700}});
    // particles: phase functions that differ between the wavelengths of a walk
    auto white = test::paint_of(1.5, {test::pigment_layer(.9, 1, 0)}, 0.1);
    white.layers[0] = {20, {}, {{particles("TiO2_rutile", 0.15, 240, 0.25)}}};
    all.push_back({"rutile, three wavelengths", white, {430, 550, 700}});
    auto tinted = test::paint_of(1.5, {test::flake_layer(0.5, .2, .6, .1)}, 0.3);
    tinted.layers[0].pigments = {{particles("Fe2O3", 0.01, 300, 0.3)},
                                 {particles("carbon_black", 0.0005, 60, 0.2)}};
    all.push_back({"flakes, red oxide and black, three wavelengths", tinted, {450, 580, 680}});
    return all;
}

// Under a rough interface every connection has a path and an extinction of its own: fewer of them.
std::vector<Case> rough_cases() {
    const auto roughened = [](paint::Recipe recipe, double roughness, double absorption_per_mm) {
        recipe.clearcoat = paint::Clearcoat{45, absorption_per_mm, roughness};
        return recipe;
    };
    const auto metallic = test::paint_of(1.5, {test::flake_layer(1.5, .1, .6, 0)});
    const auto lossless = test::paint_of(1.5, {test::flake_layer(2, .3, .4, .6)}, 1.0);
    const auto pigmented = test::paint_of(1.6, {test::pigment_layer(.9, 2, .3)}, 0.3);
    return {{"rough .1 over alpha .1", roughened(metallic, .1, 0)},
            {"rough .3 over alpha .3, R + T = 1, white", roughened(lossless, .3, 0)},
            {"rough .5, absorbing, over pigment", roughened(pigmented, .5, 6.0)}};
}

const std::vector<Direction> kIncident{{10, 0}, {45, 0}, {75, 0}};
const std::vector<Direction> kOutgoing{{0, 0},    {15, 180}, {30, 180}, {45, 180}, {60, 180},
                                       {75, 180}, {85, 180}, {45, 90},  {30, 0},   {70, 130}};
// For rough interfaces: the specular directions, near the horizon, and out of the plane. Not fewer
// walks instead: masking of both directions is drawn at random and rare, and where no walk met it
// the standard error is too small.
const std::vector<Direction> kRoughOutgoing{{10, 180}, {45, 180}, {75, 180}, {70, 130}};

// An estimate with a larger relative error is dominated by a few walks (narrow flakes far off their
// lobe): its law is skewed, and its z-score not normal.
constexpr double kSkewedRelativeError = 0.05;

// The solver's own error, as a fraction of the largest value on the grid: a tenth of
// SolverSettings::tolerance. It adds to the walk's in quadrature.
constexpr double kSolverError = 1e-5;

// |z| > 4.5 in one of 150000 values; there are some 1700.
constexpr double kWorstOfManyZ = 4.5;

double radians(double deg) { return deg * std::numbers::pi / 180; }

struct Scores {
    std::vector<double> z;
    int skewed = 0;

    std::string histogram() const {
        std::array<int, 10> bins{};
        for (double value : z) ++bins[std::clamp(static_cast<int>(std::floor(value)) + 5, 0, 9)];
        std::string text = "z of solver against random walk:\n";
        for (int i = 0; i < 10; ++i)
            text += fmt::format("{:>3} to {:>2}: {:4}\n", i - 5, i - 4, bins[i]);
        return text;
    }
    double mean_square() const {
        double sum = 0;
        for (double value : z) sum += value * value;
        return sum / static_cast<double>(z.size());
    }
};

std::vector<Estimate> walk(const Case& c, const std::vector<Direction>& outgoing, Part part,
                           std::uint64_t samples) {
    return reference_brdf(c.recipe, kIncident, outgoing, c.wavelengths_nm,
                          {.samples = samples, .seed = 2016, .part = part});
}

void compare(const Case& c, const std::vector<Direction>& outgoing, Part part,
             const std::vector<Estimate>& found, Scores& scores) {
    const solver::SolvedPaint solved = solver::solve(c.recipe, c.wavelengths_nm);
    std::vector<double> expected;
    for (const Direction& in : kIncident) {
        for (const Direction& out : outgoing) {
            for (double value : solved.brdf(radians(in.theta_deg), radians(out.theta_deg),
                                            radians(out.phi_deg - in.phi_deg), part))
                expected.push_back(value);
        }
    }
    ASSERT_EQ(expected.size(), found.size());
    const double solver_error = kSolverError * *std::max_element(expected.begin(), expected.end());
    const std::size_t values_per_incident = outgoing.size() * c.wavelengths_nm.size();
    for (std::size_t i = 0; i < found.size(); ++i) {
        if (!(found[i].standard_error <= kSkewedRelativeError * found[i].value)) {
            ++scores.skewed;
            continue;
        }
        const double z = z_score(found[i], expected[i], solver_error);
        scores.z.push_back(z);
        const Direction& in = kIncident[i / values_per_incident];
        const Direction& out = outgoing[i % values_per_incident / c.wavelengths_nm.size()];
        EXPECT_LT(std::abs(z), kWorstOfManyZ)
            << c.name << ": theta_i " << in.theta_deg << ", theta_o " << out.theta_deg << ", phi "
            << out.phi_deg << ", " << c.wavelengths_nm[i % c.wavelengths_nm.size()]
            << " nm: solver " << expected[i] << ", walk " << found[i].value << " +- "
            << found[i].standard_error;
    }
}

/// @param walks  what the walk found of a case
template <class Walks>
void compare_with(const Walks& walks, const std::vector<Case>& all,
                  const std::vector<Direction>& outgoing, Part part, std::size_t fewest) {
    Scores scores;
    for (const Case& c : all) compare(c, outgoing, part, walks(c), scores);
    fmt::print("{}{} values, {} too skewed for a z-score; mean z^2 {:.3f}\n", scores.histogram(),
               scores.z.size(), scores.skewed, scores.mean_square());
    ASSERT_GT(scores.z.size(), fewest);
    // Values that share walks are correlated. If all of one incidence were equal, the mean of z^2
    // would be chi-square over N, with N degrees of freedom for N incidences.
    const double independent = static_cast<double>(all.size() * kIncident.size());
    EXPECT_NEAR(scores.mean_square(), 1, 4 * std::sqrt(2 / independent));
}

void compare_all(const std::vector<Case>& all, const std::vector<Direction>& outgoing, Part part,
                 std::uint64_t samples, std::size_t fewest) {
    compare_with([&](const Case& c) { return walk(c, outgoing, part, samples); }, all, outgoing,
                 part, fewest);
}

/// Of the walks of solver_agreement_walks.h, which NACRE_WRITE_TRUTH=1 makes again.
constexpr std::uint64_t kFrozenWalks = 500'000, kFrozenRoughWalks = 40'000,
                        kFrozenRutileWalks = 100'000;

/// The cases that are, or are not, a white of rutile, whose walks take longer than all the others'.
std::vector<Case> rutile(bool is) {
    std::vector<Case> some;
    for (Case& c : cases()) {
        if ((c.name == "rutile, three wavelengths") == is) some.push_back(std::move(c));
    }
    return some;
}

std::string frozen_text(const char* name, const std::vector<Case>& all,
                        const std::vector<Direction>& outgoing, Part part, std::uint64_t samples) {
    std::string text = fmt::format("inline constexpr double {}[][2] = {{\n", name);
    for (const Case& c : all) {
        text += fmt::format("\n// {}\n", c.name);
        for (const Estimate& e : walk(c, outgoing, part, samples)) {
            text += fmt::format("{{{:.7g}, {:.3g}}}, ", e.value, e.standard_error);
        }
    }
    return text + "};\n";
}

/// Writes solver_agreement_walks.h; some ten minutes of one processor.
void write_walks() {
    const auto file = data_directory().parent_path() / "src/nacre/testing/solver_agreement_walks.h";
    std::string text = read_file(file);
    text.resize(text.find("inline constexpr"));
    text +=
        frozen_text("kMultipleScatteringWalks", cases(), kOutgoing, Part::multiple, kFrozenWalks) +
        frozen_text("kRoughWalks", rough_cases(), kRoughOutgoing, Part::total, kFrozenRoughWalks);
    std::ofstream(file, std::ios::binary) << text << "\n}  // namespace nacre::montecarlo::test\n";
}

template <std::size_t kCount>
void compare_with_frozen(const double (&walks)[kCount][2], const std::vector<Case>& all,
                         const std::vector<Direction>& outgoing, Part part, std::size_t fewest) {
    const auto* next = std::begin(walks);
    const auto frozen = [&](const Case& c) {
        std::vector<Estimate> of_case;
        const std::size_t count = kIncident.size() * outgoing.size() * c.wavelengths_nm.size();
        for (; of_case.size() < count && next != std::end(walks); ++next) {
            of_case.push_back({(*next)[0], (*next)[1]});
        }
        return of_case;
    };
    compare_with(frozen, all, outgoing, part, fewest);
    EXPECT_EQ(next, std::end(walks)) << "more walks than cases";
}

TEST(SolverAgreement, SingleScatteringMatchesTheRandomWalk) {
    compare_all(cases(), kOutgoing, Part::single, 10'000, 350);
}
// The walks of all cases take half a minute, most of it in the many collisions of rutile: they are
// frozen, and more of them. Three cases, and those of the other tests, are walked each time.
TEST(SolverAgreement, MultipleScatteringMatchesTheRandomWalk) {
    if (std::getenv("NACRE_WRITE_TRUTH")) {
        write_walks();
        GTEST_SKIP() << "compile what was written";
    }
    compare_with_frozen(test::kMultipleScatteringWalks, cases(), kOutgoing, Part::multiple, 350);
}
TEST(SolverAgreement, MultipleScatteringMatchesTheRandomWalkOfToday) {
    std::vector<Case> some;
    for (Case& c : cases()) {
        for (const std::string_view name :
             {"absorbing clearcoat", "TiO2 on mica", "mixture, three wavelengths"}) {
            if (c.name == name) some.push_back(std::move(c));
        }
    }
    ASSERT_EQ(some.size(), 3u);
    compare_all(some, kOutgoing, Part::multiple, 30'000, 60);
}
TEST(SolverAgreement, TotalMatchesTheRandomWalk) {
    compare_all(rutile(false), kOutgoing, Part::total, 5'000, 350);
    compare_with_frozen(test::kRutileWalks, rutile(true), kOutgoing, Part::total, 80);
}
// From nothing, through layers so thin that their Z_a nearly overflows, to opaque ones.
TEST(SolverAgreement, AnyExtinctionMatchesTheRandomWalk) {
    std::vector<Case> all;
    for (const double depth : {0.0, 1e-14, 1e-9, 1e-6, 1e-4, 1e-2, .1, 1., 10., 100., 1000.}) {
        all.push_back({fmt::format("pigment, depth {}", depth),
                       test::paint_of(1.5, {test::pigment_layer(.9, depth, .3)}, 0.5)});
    }
    compare_all(all, kOutgoing, Part::total, 10'000, 300);
}
// Frozen, and one of today.
TEST(SolverAgreement, RoughInterfacesMatchTheRandomWalk) {
    compare_with_frozen(test::kRoughWalks, rough_cases(), kRoughOutgoing, Part::total, 25);
    compare_all({rough_cases()[2]}, kRoughOutgoing, Part::total, 4'000, 8);
}

}  // namespace
}  // namespace nacre::montecarlo
