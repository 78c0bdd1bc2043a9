#include <gtest/gtest.h>

#include "nacre/bsdf/measured_merl.h"
#include "nacre/bsdf/measured_rgl.h"
#include "nacre/bsdf/microflake.h"
#include "nacre/io/merl_file.h"
#include "nacre/io/rgl_file.h"
#include "nacre/layers/solver.h"
#include "nacre/measure/acquire_merl.h"
#include "nacre/measure/acquire_rgl.h"
#include "nacre/measure/table_error.h"

// Paints that have been through a file of a measured BRDF.

namespace nacre::io {
namespace {

struct Paint {
    std::vector<double> wavelengths_nm = {450, 550, 650};
    measure::Brdf brdf;
};

Paint gold(double alpha) {
    layers::FlakeSpecies flake;
    flake.amount = layers::AreaDensity{0.1};
    flake.orientation.beckmann_alpha = alpha;
    flake.body = layers::PrescribedFlake{spectra::Spectrum({450.0, 650.0}, {0.3, 0.8}), 0.0, 0.3};
    layers::Recipe recipe;
    recipe.layers.push_back({20, {flake}, {}});
    Paint paint;
    const auto solved =
        std::make_shared<const layers::SolvedPaint>(layers::solve(recipe, paint.wavelengths_nm));
    // The three wavelengths and the last again: eight lanes are bound at a time.
    const std::shared_ptr<const bsdf::BoundBsdf> bound =
        bsdf::Microflake(solved).bind({450, 550, 650, 650, 650, 650, 650, 650});
    paint.brdf = [bound](double theta_i, double theta_o, double phi) {
        const Vec3f wi = {static_cast<float>(std::sin(theta_i)), 0,
                          static_cast<float>(std::cos(theta_i))};
        const Vec3f wo = {static_cast<float>(std::sin(theta_o) * std::cos(phi)),
                          static_cast<float>(std::sin(theta_o) * std::sin(phi)),
                          static_cast<float>(std::cos(theta_o))};
        const FloatLanes f = bound->eval(wi, wo);
        return std::vector<double>{f[0], f[1], f[2]};
    };
    return paint;
}

// Bounds of docs/measured.md.
TEST(MeasuredRoundTrip, AFlakePaintComesBackFromAnRglFile) {
    for (const auto& [alpha, flux, peak] : {std::tuple{0.1, 0.025, 0.2}, {0.3, 0.006, 0.1}}) {
        const Paint paint = gold(alpha);
        const std::string bytes =
            rgl_bytes(measure::acquire_rgl("gold", paint.brdf, paint.wavelengths_nm, {}));
        const bsdf::MeasuredRgl back(parse_rgl(bytes, "gold.bsdf"));
        const measure::TableError error =
            measure::table_error(back, paint.brdf, paint.wavelengths_nm, false);
        EXPECT_LT(error.flux, flux) << alpha;
        EXPECT_LT(error.peak, peak) << alpha;
        EXPECT_GT(error.flux, 0);
    }
}

TEST(MeasuredRoundTrip, AFlakePaintComesBackFromAMerlFile) {
    const Paint paint = gold(0.1);
    const std::string bytes =
        merl_bytes(measure::acquire_merl(paint.brdf, paint.wavelengths_nm, {}));
    const bsdf::MeasuredMerl back(parse_merl(bytes, "gold.binary"));
    const measure::TableError error =
        measure::table_error(back, paint.brdf, paint.wavelengths_nm, true);
    EXPECT_LT(error.flux, 3e-3);
    EXPECT_LT(error.peak, 0.06);
    EXPECT_GT(error.flux, 0);
}

}  // namespace
}  // namespace nacre::io
