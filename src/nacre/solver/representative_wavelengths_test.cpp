#include "nacre/solver/representative_wavelengths.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "nacre/core/math.h"
#include "nacre/solver/solver.h"
#include "nacre/testing/layers.h"
#include "nacre/testing/paints.h"

namespace nacre::solver {
namespace {

constexpr int kWavelengths = 31, kBlocks = 4;

/// Rows of which each adds up the first `rank` cosines over the wavelengths, by amounts of its own.
LaneBuffer rows_of_rank(int rank, int rows, int seed) {
    LaneBuffer out;
    for (int row = 0; row < rows; ++row) {
        for (int lane = 0; lane < kBlocks * kLanes; ++lane) {
            const int w = std::min(lane, kWavelengths - 1);
            double sum = 0;
            for (int k = 0; k < rank; ++k)
                sum += std::cos(7.0 * seed + 3.1 * row * (k + 1)) * std::cos(0.1 * k * w);
            if (lane % kLanes == 0) out.emplace_back();
            out.back()[lane % kLanes] = sum;
        }
    }
    return out;
}

double largest_difference(const LaneBuffer& a, const LaneBuffer& b) {
    DoubleLanes most{};
    for (std::size_t k = 0; k < a.size(); ++k)
        most = max_lanes(most, max_lanes(a[k] - b[k], b[k] - a[k]));
    return lane_max(most);
}

TEST(RepresentativeWavelengths, TellAllOfSpectraThatTheySpan) {
    EXPECT_TRUE(may_be_represented(rows_of_rank(6, 40, 1), kWavelengths, kLanes));
    const RepresentativeWavelengths few(rows_of_rank(6, 40, 1), kWavelengths, kLanes);
    ASSERT_EQ(few.wavelengths().size(), 6u);  // no more than are needed
    EXPECT_TRUE(std::is_sorted(few.wavelengths().begin(), few.wavelengths().end()));
    const LaneBuffer others = rows_of_rank(6, 25, 2);
    EXPECT_LT(largest_difference(few.again(others), others), 1e-11);

    const OrderValues chosen = few.chosen(others);
    ASSERT_EQ(chosen.size(), 25u);
    for (int row = 0; row < 25; ++row) {
        for (std::size_t k = 0; k < few.wavelengths().size(); ++k) {
            const int w = few.wavelengths()[k];
            EXPECT_EQ(chosen[row][static_cast<int>(k)],
                      others[row * kBlocks + w / kLanes][w % kLanes]);
        }
        OrderValues all(kBlocks);
        few.at_all(&chosen[row], all.data());
        const auto begin = others.begin() + row * kBlocks;
        EXPECT_LT(largest_difference(all, {begin, begin + kBlocks}), 1e-11);
    }
}

TEST(RepresentativeWavelengths, TellApartWhatTheyDoNotSpan) {
    EXPECT_FALSE(may_be_represented(rows_of_rank(14, 40, 1), kWavelengths, kLanes));
    const RepresentativeWavelengths few(rows_of_rank(14, 40, 1), kWavelengths, kLanes);
    EXPECT_EQ(few.wavelengths().size(), std::size_t{kLanes});
    const LaneBuffer others = rows_of_rank(14, 25, 2);
    EXPECT_GT(largest_difference(few.again(others), others), 1e-3);
}

const std::vector<double> kNm = [] {
    std::vector<double> nm;
    for (int w = 0; w < kWavelengths; ++w) nm.push_back(400 + 10 * w);
    return nm;
}();
const spectra::Spectrum kSilver({400, 550, 700}, {0.85, 0.9, 0.94});

/// Holds a paint to its wavelengths solved alone.
/// @param brightest  the wavelength to whose peak errors are held; -1: each to its own
void expect_as_alone(const paint::Recipe& recipe, int brightest = -1) {
    const SolverSettings settings{.exit_nodes = 24, .inner_nodes = 16};
    const auto peak = [](const SolvedPaint& paint, int w) {
        return paint.brdf(45 * kDegree, 45 * kDegree, std::numbers::pi)[w];
    };
    const SolvedPaint all = solve(recipe, kNm, settings);
    for (const int w : {0, 7, 16, 29}) {
        const SolvedPaint alone = solve(recipe, {kNm[w]}, settings);
        const double scale = brightest < 0 ? peak(alone, 0) : peak(all, brightest);
        for (const double theta_o : {-60.0, -45.0, -30.0, 0.0, 50.0}) {
            const double phi = theta_o < 0 ? std::numbers::pi : 0.0;
            const double a = all.brdf(45 * kDegree, std::abs(theta_o) * kDegree, phi)[w];
            const double b = alone.brdf(45 * kDegree, std::abs(theta_o) * kDegree, phi)[0];
            // What compress() rounds, of these wavelengths or of one.
            EXPECT_NEAR(a, b, 2e-5 * scale) << kNm[w] << " nm, " << theta_o;
        }
    }
}

// Metals, whose further orders are solved at a few of the wavelengths, and films, whose are not.
TEST(RepresentativeWavelengths, APaintIsAsItsWavelengthsSolvedAlone) {
    const spectra::Spectrum green({400, 550, 700}, {0.2, 0.5, 0.2});
    paint::Recipe smooth = test::flake_paint(0.05, kSilver, 0, 3, 1.5), rough = smooth;
    rough.layers.push_back(nacre::test::pigment_layer(0.8, 2, 0.5));
    rough.clearcoat = paint::Clearcoat{.thickness_um = 40, .roughness = 0.15};
    paint::Recipe dyed = smooth;
    dyed.clearcoat = paint::Clearcoat{40, green, 0.0};
    paint::Recipe film = smooth;
    film.layers[0].flakes[0].body = optics::Platelet{.core = {optics::Material(1.58), 450, {}},
                                                     .coats = {{optics::Material(2.5), 300, {}}}};
    // Whose colour changes so much within a lobe that orders beyond the first ones differ as well.
    const auto metal = [](optics::ComplexIndex n) {
        return optics::Material("metal", {400, 700}, std::vector<optics::ComplexIndex>{n, n});
    };
    paint::Recipe interference = smooth;
    interference.layers[0].flakes[0].body =
        optics::Platelet{.core = {metal({0.8, 6.0}), 80, {}},
                         .coats = {{optics::Material(1.45), 450, {}}, {metal({3.0, 3.3}), 8, {}}}};
    for (const paint::Recipe& recipe : {smooth, rough, dyed, film, interference}) {
        expect_as_alone(recipe);
    }
}

// What it is made of has few spectra, so that few wavelengths are looked for; its orders have many.
TEST(RepresentativeWavelengths, AMetalUnderADeepDyeIsSolvedAtAllWavelengths) {
    paint::Recipe recipe = test::flake_paint(0.05, kSilver, 0, 3, 1.5);
    recipe.clearcoat =
        paint::Clearcoat{40, spectra::Spectrum({400, 550, 700}, {0.0, 120.0, 20.0}), 0.0};
    expect_as_alone(recipe, 0);
}

}  // namespace
}  // namespace nacre::solver
