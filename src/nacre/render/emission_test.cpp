#include "nacre/render/emission.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "nacre/render/environment.h"
#include "nacre/render/lights.h"
#include "nacre/render/render.h"

namespace nacre::render {
namespace {

/// A picture of nothing but the environment.
RenderResult picture_of(const Environment& environment, int samples = 256, int bins = 0) {
    SceneDescription scene;
    scene.environment = environment;
    scene.camera = {.position_mm = {0, 0, 0}, .target_mm = {0, 100, 50}, .vertical_fov_deg = 1};
    return render(Scene(scene, {}),
                  {.width = 2, .height = 2, .samples_per_pixel = samples, .spectral_bins = bins});
}

// X and Z of E by the CIE sums are 1.00008 and 1.00034; the ends of the spectrum are missing.
TEST(Emission, EqualEnergySpectrumHasUnitXyzInTheMeanOverPasses) {
    constexpr int kPasses = 1024;
    double mean[3] = {};
    for (int k = 0; k < kPasses; ++k) {
        const XyzWeights weights = film_xyz_weights(film_wavelengths(k, kPasses));
        for (int c = 0; c < 3; ++c) mean[c] += lane_sum(weights[c]) / kPasses;
    }
    EXPECT_NEAR(mean[0], 1, 5e-3);
    EXPECT_NEAR(mean[1], 1, 1e-5);
    EXPECT_NEAR(mean[2], 1, 5e-3);
}

TEST(Emission, WeightsAreProportionalToTheObserver) {
    const bsdf::Wavelengths nm = film_wavelengths(5, 8);
    const XyzWeights weights = film_xyz_weights(nm);
    const auto observer = spectra::Observer::cie1931_2deg;
    const double scale = weights[1][4] / spectra::colour_matching(observer, nm[4])[1];
    for (int k = 0; k < kLanes; ++k) {
        const auto matching = spectra::colour_matching(observer, nm[k]);
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(weights[c][k], scale * matching[c], 1e-6);
    }
}

TEST(Emission, UnitIlluminantsHaveLuminanceOne) {
    for (auto illuminant : {spectra::Illuminant::A, spectra::Illuminant::D65,
                            spectra::Illuminant::FL11, spectra::Illuminant::E}) {
        EXPECT_NEAR(film_luminance(unit_illuminant(illuminant)), 1, 1e-12);
    }
}

TEST(Emission, D65IsWhiteFromTheFirstSample) {
    for (int samples : {1, 3, 64}) {
        for (float value : picture_of(ConstantEnvironment{}, samples).rgb) {
            EXPECT_NEAR(value, 1, 2e-6) << samples;
        }
    }
}

TEST(Emission, LampsWithLinesHaveTheirLightInFull) {
    for (const auto illuminant : {spectra::Illuminant::FL2, spectra::Illuminant::FL11}) {
        EmissionBasis basis;
        basis.add(unit_illuminant(illuminant));
        for (const std::uint32_t passes : {16u, 61u, 64u, 100u, 256u, 1000u}) {
            double luminance = 0;
            for (std::uint32_t pass = 0; pass < passes; ++pass) {
                const bsdf::Wavelengths nm = film_wavelengths(pass, passes);
                luminance += lane_sum(film_xyz_weights(nm)[1] * basis.at(nm)[0]) / passes;
            }
            // By the squared distance of the wavelengths, 2.3 nm of 16 passes, and that of
            // film_luminance()'s, 1 nm.
            EXPECT_NEAR(luminance, 1, 1.3 / (double(passes) * passes) + 5e-5) << passes;
        }
    }
}

// Each of as many evenly spaced offsets once.
TEST(Emission, WavelengthsOfPassesAreEven) {
    for (const std::uint32_t passes : {1u, 2u, 3u, 6u, 16u, 30u, 64u, 210u, 4096u, 30030u}) {
        const double spacing_nm = (kFilmLast_nm - kFilmFirst_nm) / kLanes / passes;
        std::vector<double> first;
        for (std::uint32_t pass = 0; pass < passes; ++pass) {
            const bsdf::Wavelengths nm = film_wavelengths(pass, passes);
            first.push_back(nm[0] - kFilmFirst_nm);
            EXPECT_NEAR(nm[kLanes - 1] - nm[0], (kFilmLast_nm - kFilmFirst_nm) * 7 / 8, 1e-3);
        }
        std::sort(first.begin(), first.end());
        for (std::uint32_t i = 0; i < passes; ++i) {
            EXPECT_NEAR(first[i], (i + 0.5) * spacing_nm, 1e-3) << passes;
        }
    }
}

TEST(Emission, IlluminantAIsOrangeAsCieSays) {
    const auto rgb = picture_of(ConstantEnvironment{.radiance = {spectra::Illuminant::A}}).rgb;
    // xy of illuminant A: 0.44758, 0.40745 at Y = 1.
    //                                                                      [cie-15-2018, table T.3]
    const auto expected = spectra::xyz_to_linear_rec709({0.44758 / 0.40745, 1, 0.14497 / 0.40745});
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(rgb[c], expected[c], 5e-3);
}

/// What a bin shows of a spectrum: light is shared out between the two bins whose centres are
/// nearest, so that it counts by a tent over the bin and half of its neighbours, or beyond the
/// outermost centres in full.
double shown_in_bin(const spectra::Spectrum& spectrum, double centre_nm, double width_nm) {
    constexpr double kStep_nm = 0.01;
    double sum = 0, weights = 0;
    for (double nm = kFilmFirst_nm + kStep_nm / 2; nm < kFilmLast_nm; nm += kStep_nm) {
        const double shared =
            std::clamp(nm, kFilmFirst_nm + width_nm / 2, kFilmLast_nm - width_nm / 2);
        const double weight = std::max(0.0, 1 - std::abs(shared - centre_nm) / width_nm);
        sum += weight * spectrum(nm);
        weights += weight;
    }
    return sum / weights;
}

TEST(Emission, SpectralFilmReturnsTheSpectrum) {
    const auto d65 = unit_illuminant(spectra::Illuminant::D65);
    const RenderResult r = picture_of(ConstantEnvironment{}, 512, 30);
    ASSERT_EQ(r.bin_centres_nm.size(), 30u);
    EXPECT_EQ(r.bin_centres_nm[0], 405);
    for (int b = 0; b < 30; ++b) {
        const double expected = shown_in_bin(d65, r.bin_centres_nm[b], 10);
        // The wavelengths of 512 passes lie evenly to some 1/512 of a lane's 37.5 nm: the worst bin
        // is 2e-4 off. D65's own value at the centre would be 4e-3 off.
        EXPECT_NEAR(r.spectral[b], expected, 4e-4 * expected) << r.bin_centres_nm[b];
    }
    const RenderResult e =
        picture_of(ConstantEnvironment{.radiance = {spectra::Illuminant::E}}, 2, 50);
    for (float value : e.spectral) EXPECT_NEAR(value, 1, 1e-5);
}

TEST(Emission, MapTexelsKeepTheirColourAndPlace) {
    // Four columns over two rows; the middle of the picture lies at azimuth 90, where we look.
    ImageEnvironment image{.width = 4, .height = 2, .rgb = {}};
    for (int row = 0; row < 2; ++row) {
        for (int column = 0; column < 4; ++column) {
            const bool left = column < 2;
            for (float value : {left ? 0.8f : 0.2f, 0.5f, 0.1f}) image.rgb.push_back(value);
        }
    }
    EmissionBasis basis;
    const CompiledEnvironment compiled = compile_environment(image, basis);
    EXPECT_NEAR(compiled.radiance->luminance(direction_from_angles(135, 0)),
                0.2126 * 0.8 + 0.7152 * 0.5 + 0.0722 * 0.1, 1e-5);  // left of the middle
    EXPECT_NEAR(compiled.radiance->luminance(direction_from_angles(45, 0)),
                0.2126 * 0.2 + 0.7152 * 0.5 + 0.0722 * 0.1, 1e-5);
    image.rgb.clear();
    for (int i = 0; i < 8; ++i) image.rgb.insert(image.rgb.end(), {0.8f, 0.5f, 0.1f});
    const auto rgb = picture_of(image).rgb;
    // The primaries' reflectances match their colours to the upsampling's own tolerance, and the
    // film ends at 400 and 700 nm.
    EXPECT_NEAR(rgb[0], 0.8, 0.01);
    EXPECT_NEAR(rgb[1], 0.5, 0.01);
    EXPECT_NEAR(rgb[2], 0.1, 0.01);
}

// M1 and M2 of D65 (6504 K): the CIE defines D65 by this very sum.       [cie-15-2018, 4.1.3]
TEST(Emission, DaylightBasisReproducesD65) {
    const auto basis = daylight_basis();
    for (double nm = 400; nm <= 700; nm += 10) {
        const double sum = basis[0](nm) - 0.29634 * basis[1](nm) - 0.68832 * basis[2](nm);
        EXPECT_NEAR(sum, spectra::illuminant_power(spectra::Illuminant::D65, nm), 0.2) << nm;
    }
}

struct Sky {
    explicit Sky(const SkyEnvironment& description) : compiled(compile_sky(description, basis)) {}
    EmissionBasis basis;
    CompiledEnvironment compiled;
};

/// Illuminance of the sky dome on the ground, in klx.
double dome_klx(const Sky& sky) {
    constexpr int kSteps = 64;
    double sum = 0;
    for (int i = 0; i < kSteps * kSteps; ++i) {
        const double elevation = std::acos(std::sqrt((i / kSteps + 0.5) / kSteps)) * 180 / M_PI;
        sum += sky.compiled.radiance->luminance(
            direction_from_angles(360 * (i % kSteps + 0.5) / kSteps, elevation));
    }
    return 10 * M_PI * sum / (kSteps * kSteps);
}

// Measured daylight under clear skies: 80 to 100 klx from the sun at 60 deg, 10 to 25 klx from
// the dome.                                                     [iesna-2011]
TEST(Sky, BrightnessIsThatOfClearDays) {
    const Sky sky({.sun_elevation_deg = 60, .turbidity = 2.5});
    const DistantDisk& sun = *sky.compiled.sun;
    const double sun_klx = 10 * sun.luminance * M_PI * sun.chord_squared * sun.direction.z;
    EXPECT_GT(sun_klx, 70);
    EXPECT_LT(sun_klx, 105);
    EXPECT_GT(dome_klx(sky), 8);
    EXPECT_LT(dome_klx(sky), 30);
}

TEST(Sky, IsBlueAboveAndTheLowSunIsRed) {
    const Sky sky({.sun_elevation_deg = 5});
    const auto red_over_blue = [&](const spectra::Spectrum& s) { return s(650) / s(450); };
    const auto nm = film_wavelengths(0, 1);
    const auto basis = sky.basis.at(nm);
    const FloatLanes zenith = sky.compiled.radiance->radiance({0, 0, 1}, basis.data());
    EXPECT_GT(zenith[1], 1.5f * zenith[6]);
    const double low = red_over_blue(sky.basis[sky.compiled.sun->spectrum]);
    const Sky noon({.sun_elevation_deg = 80});
    EXPECT_GT(low, 3 * red_over_blue(noon.basis[noon.compiled.sun->spectrum]));
}

TEST(Sky, RadianceHasTheLuminanceThatGuidesSampling) {
    const SkyEnvironment description{.sun_azimuth_deg = 30, .sun_elevation_deg = 35};
    const Sky sky(description);
    for (double azimuth : {0.0, 100.0, 250.0}) {
        for (double elevation : {-20.0, 3.0, 40.0, 80.0}) {
            const Vec3f d = direction_from_angles(azimuth, elevation);
            double luminance = 0;
            constexpr int kPasses = 64;
            for (int k = 0; k < kPasses; ++k) {
                const auto nm = film_wavelengths(k, kPasses);
                const auto basis = sky.basis.at(nm);
                luminance += lane_sum(film_xyz_weights(nm)[1] *
                                      sky.compiled.radiance->radiance(d, basis.data())) /
                             kPasses;
            }
            const double expected = sky.compiled.radiance->luminance(d);
            EXPECT_NEAR(luminance, expected, 2e-3 * expected) << azimuth << " " << elevation;
        }
    }
}

// Light that is spread out is as much: the mean over the sphere of sky and sun, of a picture with one
// bright pixel, and of a studio with a small lamp, over disks of many sizes.
TEST(Sky, SpreadOutForMirrorsItGivesAsMuchLight) {
    ImageEnvironment image{256, 128, std::vector<float>(std::size_t{3} * 256 * 128, 0.5f)};
    for (int c = 0; c < 3; ++c) image.rgb[3 * (40 * 256 + 30) + c] = 20'000;
    const StudioEnvironment studio{.boxes = {{.azimuth_deg = 50,
                                              .elevation_deg = 30,
                                              .width_deg = 2,
                                              .height_deg = 2,
                                              .softness = 0,
                                              .scale = 5'000}}};
    for (const Environment& environment : {Environment(SkyEnvironment{.sun_elevation_deg = 35}),
                                           Environment(image), Environment(studio)}) {
        EmissionBasis basis;
        const LightSet lights({}, environment, {}, 1, basis);
        const bsdf::Wavelengths nm = film_wavelengths(0, 1);
        const XyzWeights xyz = film_xyz_weights(nm);
        const auto spectra = basis.at(nm);
        const auto luminance = [&](const FloatLanes& l) { return lane_sum(xyz[1] * l); };
        constexpr std::array kSolidAngles{0.25f, 0.03f, 0.004f};
        double sharp = 0, largest = 0;
        std::array<double, 3> spread{}, largest_spread{};
        constexpr int kAround = 8192, kUp = 4096;  // the sun is met by 45 of them
        constexpr int kCoarser = 5;                // for light that is spread out
        for (int i = 0; i < kUp; ++i) {
            const double z = 2 * (i + 0.5) / kUp - 1, sine = std::sqrt(1 - z * z);
            for (int j = i % 4; j < kAround; j += 4) {
                const double azimuth = 2 * M_PI * (j + 0.5) / kAround;
                const Vec3f d{static_cast<float>(sine * std::cos(azimuth)),
                              static_cast<float>(sine * std::sin(azimuth)), static_cast<float>(z)};
                const double a = luminance(
                    lights.escaped(d, spectra.data(), [](const LightPdf&) { return 1.0f; }));
                sharp += a;
                largest = std::max(largest, a);
                if (i % kCoarser != 0) continue;
                for (std::size_t k = 0; k < kSolidAngles.size(); ++k) {
                    const double b =
                        luminance(lights.escaped_spread(d, kSolidAngles[k], spectra.data()));
                    spread[k] += kCoarser * b;
                    largest_spread[k] = std::max(largest_spread[k], b);
                }
            }
        }
        for (std::size_t k = 0; k < kSolidAngles.size(); ++k) {
            EXPECT_NEAR(spread[k] / sharp, 1, 0.03) << kSolidAngles[k];
            EXPECT_LT(largest_spread[k], 0.5 * largest) << kSolidAngles[k];
        }
        EXPECT_LT(largest_spread[0], 0.02 * largest);
        // What is smaller than the least cell and the sun leaves all as it is.
        const Vec3f at = direction_from_angles(50, 30);
        EXPECT_EQ(
            luminance(lights.escaped_spread(at, 1e-7f, spectra.data())),
            luminance(lights.escaped(at, spectra.data(), [](const LightPdf&) { return 1.0f; })));
    }
}

TEST(Sky, EveryDirectionIsFiniteForEveryTurbidityAndSun) {
    int checked = 0;
    for (double turbidity : {1.7, 3.0, 6.0, 10.0}) {
        for (double sun : {0.0, 1.0, 30.0, 90.0}) {
            const Sky sky({.sun_elevation_deg = sun, .turbidity = turbidity});
            const auto basis = sky.basis.at(film_wavelengths(3, 4));
            for (double elevation = -90; elevation <= 90; elevation += 7.5) {
                const FloatLanes l = sky.compiled.radiance->radiance(
                    direction_from_angles(17 * elevation, elevation), basis.data());
                for (int i = 0; i < kLanes; ++i) {
                    EXPECT_TRUE(std::isfinite(l[i]) && l[i] >= 0) << turbidity << " " << sun;
                }
                ++checked;
            }
        }
    }
    EXPECT_EQ(checked, 4 * 4 * 25);
}

}  // namespace
}  // namespace nacre::render
