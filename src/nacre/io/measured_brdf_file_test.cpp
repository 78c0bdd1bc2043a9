#include "nacre/io/measured_brdf_file.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <functional>
#include <numbers>

#include "nacre/bsdf/measured/merl.h"
#include "nacre/bsdf/measured/rgl.h"
#include "nacre/bsdf/models/microflake.h"
#include "nacre/bsdf/wavelength_lanes.h"
#include "nacre/core/error.h"
#include "nacre/core/math.h"
#include "nacre/core/random.h"
#include "nacre/measure/acquire.h"
#include "nacre/solver/solver.h"
#include "nacre/testing/bsdf.h"
#include "nacre/testing/errors.h"
#include "nacre/testing/files.h"
#include "nacre/testing/paints.h"

namespace nacre::io {
namespace {

using bsdf::direction;
using nacre::test::message_of;
using ::testing::HasSubstr;

/// A table of random numbers, the same everywhere, that no measurement would give: whatever is
/// looked up at a wrong place or in a wrong order shows.
/// @param parts  how often the measured azimuths fit into the circle; 0: isotropic
bsdf::RglTable random_table(int parts, bool rgb, bool jacobian = true) {
    Rng rng(7, 3);
    const auto fill = [&](std::vector<float>& values, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) values.push_back(0.2f + rng.uniform_float());
    };
    bsdf::RglTable table;
    table.description = "random numbers";
    table.jacobian = jacobian;
    constexpr float kPi = std::numbers::pi_v<float>;
    if (parts == 0) {
        table.phi_i = {0.0f};
    } else {
        for (int i = 0; i < 5; ++i) table.phi_i.push_back(-kPi + i * 2 * kPi / (4.0f * parts));
    }
    table.theta_i = {0.1f, 0.5f, 1.0f, 1.4f};
    table.ndf = {6, 5, {}};
    fill(table.ndf.values, 30);
    table.sigma = {4, 7, {}};
    fill(table.sigma.values, 28);
    // Facets of an isotropic surface are alike from all sides; Mitsuba does not look from all.
    for (int i = 7; i < 28 && parts == 0; ++i) table.sigma.values[i] = table.sigma.values[i - 7];
    table.vndf_rows = 8;
    table.vndf_columns = 9;
    fill(table.vndf, table.slices() * 72);
    table.resolution = 5;
    fill(table.luminance, table.slices() * 25);
    if (!rgb) table.wavelengths = {420, 500, 520, 700};
    fill(table.spectra, table.slices() * table.channels() * 25);
    return table;
}

/// What Mitsuba 3.9.1 (pip install mitsuba; plugin "measured", variant scalar_spectral) gives for
/// rgl_bytes(random_table(parts, false, jacobian)):
///     bsdf = mi.load_dict({"type": "measured", "filename": ...})
///     si.wi = ...; si.wavelengths = [400, 470, 555, 610]
///     bsdf.eval(mi.BSDFContext(), si, wo), bsdf.pdf(mi.BSDFContext(), si, wo)
/// Its eval() includes cos(theta_o).
struct MitsubaValue {
    int parts;
    bool jacobian;
    double theta_i, phi_i, theta_o, phi_o;  ///< deg
    float value[4];
    float pdf;
};
const MitsubaValue kMitsuba[] = {
    {0, true, 20, 30, 35, 200, {0.140385f, 0.16356f, 0.149387f, 0.160466f}, 0.443413f},
    {0, true, 50, -70, 10, 15, {0.272711f, 0.231797f, 0.231124f, 0.205055f}, 0.0531084f},
    {0, true, 70, 100, 60, -60, {0.160324f, 0.140312f, 0.145218f, 0.134269f}, 0.165363f},
    {0, true, 5, -160, 80, 120, {0.446198f, 0.382079f, 0.376855f, 0.38919f}, 0.0385117f},
    {0, true, 85, 10, 40, -170, {0.396148f, 0.219517f, 0.158903f, 0.183038f}, 0.157841f},
    {1, true, 20, 30, 35, 200, {0.104955f, 0.116699f, 0.0910036f, 0.0809104f}, 0.245075f},
    {1, true, 50, -70, 10, 15, {0.275241f, 0.284956f, 0.259844f, 0.250961f}, 0.0527378f},
    {1, true, 70, 100, 60, -60, {0.149228f, 0.137386f, 0.155893f, 0.159391f}, 0.179022f},
    {1, true, 5, -160, 80, 120, {0.212941f, 0.234403f, 0.219318f, 0.218573f}, 0.0335962f},
    {1, true, 85, 10, 40, -170, {0.0741133f, 0.0739234f, 0.124585f, 0.135734f}, 0.210064f},
    {2, true, 20, 30, 35, 200, {0.09204f, 0.109975f, 0.112163f, 0.109168f}, 0.236632f},
    {2, true, 50, -70, 10, 15, {0.28291f, 0.271132f, 0.307218f, 0.27547f}, 0.0494723f},
    {2, true, 70, 100, 60, -60, {0.249725f, 0.194932f, 0.234829f, 0.220052f}, 0.19614f},
    {2, true, 5, -160, 80, 120, {0.238343f, 0.226203f, 0.222769f, 0.219579f}, 0.0292512f},
    {2, true, 85, 10, 40, -170, {0.564079f, 0.485457f, 0.445638f, 0.368744f}, 0.0815023f},
    {4, true, 20, 30, 35, 200, {0.094731f, 0.112135f, 0.114223f, 0.114783f}, 0.293937f},
    {4, true, 50, -70, 10, 15, {0.254918f, 0.254783f, 0.243234f, 0.227716f}, 0.0496005f},
    {4, true, 70, 100, 60, -60, {0.198831f, 0.193308f, 0.166574f, 0.170491f}, 0.177975f},
    {4, true, 5, -160, 80, 120, {0.298669f, 0.212689f, 0.226166f, 0.219869f}, 0.0196063f},
    {4, true, 85, 10, 40, -170, {0.537812f, 0.429069f, 0.436171f, 0.367264f}, 0.106004f},
    {1, false, 20, 30, 35, 200, {0.704392f, 0.78321f, 0.610757f, 0.543018f}, 0.245075f},
    {1, false, 50, -70, 10, 15, {0.719724f, 0.74513f, 0.679463f, 0.656236f}, 0.0527378f},
};
/// The same with scalar_rgb for random_table(parts, true): red, green, blue.
struct MitsubaColour {
    int parts;
    double theta_i, phi_i, theta_o, phi_o;
    float rgb[3];
};
const MitsubaColour kMitsubaColours[] = {
    {0, 20, 30, 35, 200, {0.16519992f, 0.15620704f, 0.12421416f}},
    {0, 50, -70, 10, 15, {0.22164275f, 0.20214324f, 0.24695699f}},
    {4, 20, 30, 35, 200, {0.10388806f, 0.08231401f, 0.1179584f}},
    {4, 70, 100, 60, -60, {0.1663266f, 0.15957186f, 0.18269126f}},
};

std::string changed(std::vector<TensorField> fields, const std::string& name,
                    const std::function<void(TensorField&)>& change) {
    int found = 0;
    for (TensorField& field : fields) {
        if (field.name != name) continue;
        ++found;
        change(field);
    }
    EXPECT_EQ(found, 1) << name;
    return tensor_file_bytes(fields);
}

void expect_refused(const std::string& bytes, const std::string& message) {
    EXPECT_THAT(message_of<InputError>([&] { parse_rgl(bytes, "broken.bsdf"); }),
                AllOf(::testing::StartsWith("broken.bsdf: "), HasSubstr(message)));
}

TEST(RglFile, EvaluatesAsInMitsuba) {
    const bsdf::Wavelengths wavelengths = {400, 470, 555, 610, 400, 470, 555, 610};
    for (const MitsubaValue& v : kMitsuba) {
        SCOPED_TRACE(fmt::format("{} parts, theta_i {}", v.parts, v.theta_i));
        const bsdf::RglTable written = random_table(v.parts, false, v.jacobian);
        const bsdf::MeasuredRgl model(parse_rgl(rgl_bytes(written), "a.bsdf"));
        const auto bound = model.bind(wavelengths);
        const Vec3f wi = direction(v.theta_i, v.phi_i), wo = direction(v.theta_o, v.phi_o);
        const FloatLanes f = bound->eval(wi, wo) * wo.z;
        // Single precision there and here, in chains of interpolations.
        for (int i = 0; i < 4; ++i) EXPECT_NEAR(f[i], v.value[i], 2e-5 * v.value[i]);
        EXPECT_NEAR(bound->pdf(wi, wo), v.pdf, 2e-5 * v.pdf);
    }
    for (const MitsubaColour& v : kMitsubaColours) {
        const auto bound = bsdf::MeasuredRgl(random_table(v.parts, true)).bind(wavelengths);
        const Vec3f wi = direction(v.theta_i, v.phi_i), wo = direction(v.theta_o, v.phi_o);
        const FloatLanes f = bound->eval(wi, wo) * wo.z;
        const FloatLanes wanted = bsdf::RgbLanes(wavelengths)({v.rgb[0], v.rgb[1], v.rgb[2]});
        for (int i = 0; i < 4; ++i) EXPECT_NEAR(f[i], wanted[i], 2e-5 * wanted[i]);
    }
}

// eval() and pdf() are compared with Mitsuba's above, and here with sample(), in every part of the
// circle to which a symmetry extends the table.
TEST(RglFile, SamplesOfEverySymmetryAgreeWithEval) {
    const bsdf::Wavelengths wavelengths = {400, 470, 555, 610, 400, 470, 555, 610};
    for (const int parts : {0, 1, 2, 4}) {
        const auto bound = bsdf::MeasuredRgl(random_table(parts, false)).bind(wavelengths);
        for (const double phi_i : {30.0, 110.0, -110.0, -20.0}) {
            SCOPED_TRACE(fmt::format("{} parts, phi_i {}", parts, phi_i));
            const Vec3f wi = direction(40, phi_i);
            Rng rng(11, 2);
            int compared = 0;
            for (int i = 0; i < 200; ++i) {
                const auto s = bound->sample(wi, 0.5f, {rng.uniform_float(), rng.uniform_float()});
                if (!s || s->wo.z < 0.05f) continue;
                // The half vector is found again with the rounding of single precision, 1e-7, of which
                // the density's pole at the normal makes the most.
                const Vec3f half = normalize(wi + s->wo);
                if (std::hypot(half.x, half.y) < 2e-5f) continue;
                const bsdf::BsdfValue both = bound->evaluate(wi, s->wo);
                ASSERT_NEAR(s->pdf, both.pdf, 3e-3f * both.pdf);
                ASSERT_NEAR(s->weight[1] * s->pdf, both.f[1] * s->wo.z, 3e-3f * both.f[1]);
                ++compared;
            }
            EXPECT_GT(compared, 100);
            // Int f cos over the hemisphere; f cos has no pole.
            double reflected = 0;
            constexpr int kCosines = 100, kAzimuths = 200;
            for (int k = 0; k < kCosines * kAzimuths; ++k) {
                const double cosine = (k % kCosines + 0.5) / kCosines;
                const double phi = (k / kCosines + 0.5) * 360 / kAzimuths;
                reflected += bound->eval(wi, direction(std::acos(cosine) / kDegree, phi))[1] *
                             cosine * 2 * std::numbers::pi / (kCosines * kAzimuths);
            }
            const auto [mean, error] = bsdf::mean_weight(*bound, wi, 1, 40000, 3);
            EXPECT_NEAR(mean, reflected, 4 * error + 0.01 * reflected);  // midpoints over jumps
        }
    }
}

// With f cos(theta_o) the same everywhere the albedo is 2 pi times that, whatever the symmetry.
TEST(RglFile, AlbedoIsTheIntegralOverTheHemisphere) {
    for (const int parts : {0, 1, 2, 4}) {
        bsdf::RglTable table = random_table(parts, true);
        std::fill(table.ndf.values.begin(), table.ndf.values.end(), 0.5f);
        std::fill(table.sigma.values.begin(), table.sigma.values.end(), 0.25f);
        std::fill(table.luminance.begin(), table.luminance.end(), 1.0f);
        std::fill(table.spectra.begin(), table.spectra.end(), 0.2f);
        // Half vectors of equal density over the hemisphere.
        for (std::size_t i = 0; i < table.vndf.size(); ++i) {
            const double x = static_cast<double>(i % table.vndf_columns) / (table.vndf_columns - 1);
            table.vndf[i] = static_cast<float>(x * std::sin(0.5 * std::numbers::pi * x * x));
        }
        const auto bound = bsdf::MeasuredRgl(table).bind({420, 450, 480, 510, 540, 570, 600, 630});
        for (const double phi_i : {30.0, 110.0, -110.0, -20.0}) {
            // 24 x 24 samples over a kink at the horizon.
            EXPECT_NEAR(bound->albedo(direction(40, phi_i))[2],
                        2 * std::numbers::pi * 0.2 * 0.5 / (4 * 0.25), 0.02)
                << parts;
        }
    }
}

TEST(RglFile, WriteReadWriteGivesTheSameBytes) {
    for (const bool rgb : {false, true}) {
        for (const int parts : {0, 1, 2, 4}) {
            const bsdf::RglTable table = random_table(parts, rgb, parts != 1);
            const std::string bytes = rgl_bytes(table);
            EXPECT_TRUE(looks_like_rgl(bytes));
            const bsdf::RglTable back = parse_rgl(bytes, "a.bsdf");
            EXPECT_EQ(back, table);
            EXPECT_EQ(rgl_bytes(back), bytes);
        }
    }
}

TEST(RglFile, IsWrittenWholeAndReadByItsName) {
    const nacre::test::TempFolder folder;
    const auto path = folder / "paint.bsdf";
    const bsdf::RglTable table = random_table(0, true);
    write_rgl(path, table);
    EXPECT_EQ(read_rgl(path), table);
    std::filesystem::remove(path);
    EXPECT_THROW(read_rgl(path), InputError);
}

TEST(RglFile, FieldsThatAreNotUsedMayBeThere) {
    const bsdf::RglTable table = random_table(0, true);
    std::vector<TensorField> fields = parse_tensor_file(rgl_bytes(table), "a.bsdf");
    fields.push_back({"valid", TensorType::uint8, {2, 2}, "abcd"});
    EXPECT_EQ(parse_rgl(tensor_file_bytes(fields), "a.bsdf"), table);
}

TEST(RglFile, EveryPieceOfAFileIsRefused) {
    const std::string bytes = rgl_bytes(random_table(0, true));
    for (std::size_t size = 0; size < bytes.size(); size += size < 600 ? 1 : 97) {
        EXPECT_THROW(parse_rgl(std::string_view(bytes).substr(0, size), "a.bsdf"), InputError);
    }
}

TEST(RglFile, ErrorsNameFieldValueAndWhatIsAllowed) {
    const std::string bytes = rgl_bytes(random_table(2, false));
    const std::vector<TensorField> fields = parse_tensor_file(bytes, "a.bsdf");
    const auto set_float = [](std::size_t at, float value) {
        return [=](TensorField& field) { std::memcpy(field.bytes.data() + 4 * at, &value, 4); };
    };
    expect_refused("tensor_fill", "is not a tensor file");
    expect_refused(changed(fields, "spectra", [](auto& f) { f.name = "spektra"; }),
                   "field spectra is missing");
    expect_refused(changed(fields, "spectra", [](auto& f) { f.name = "rgb"; }),
                   "field rgb and spectra are both there");
    expect_refused(changed(fields, "vndf",
                           [](auto& f) {
                               f.shape = {20, 72};
                           }),
                   "field vndf has rank 2: must be 4");
    expect_refused(changed(fields, "vndf",
                           [](auto& f) {
                               f.shape = {4, 5, 8, 9};
                           }),
                   "field vndf has shape 4 x 5 x 8 x 9: must begin with 5 x 4");
    expect_refused(changed(fields, "theta_i",
                           [](auto& f) {
                               f.type = TensorType::uint8;
                               f.shape = {16};
                           }),
                   "field theta_i has type uint8: must be float32");
    expect_refused(changed(fields, "theta_i", set_float(3, 2.0f)),
                   "field theta_i[3] = 2: must be a number in [0, 1.570");
    expect_refused(changed(fields, "theta_i", set_float(1, 0.05f)),
                   "field theta_i[1] = 0.05 follows 0.1: the values must increase");
    expect_refused(changed(fields, "phi_i", set_float(4, -0.7f)), "field phi_i spans 2.44");
    expect_refused(changed(fields, "phi_i",
                           [](auto& f) {
                               const float half_circle[] = {0, 0.8f, 1.6f, 2.4f, 3.14159f};
                               std::memcpy(f.bytes.data(), half_circle, sizeof half_circle);
                           }),
                   "field phi_i begins at 0 rad");
    expect_refused(changed(fields, "sigma", set_float(2, 0.0f)),
                   "field sigma[2] = 0: must be a number in [1e-09, 1");
    expect_refused(changed(fields, "luminance", set_float(9, -1.0f)), "field luminance[9] = -1");
    expect_refused(changed(fields, "spectra", set_float(5, NAN)), "field spectra[5] = nan");
    expect_refused(changed(fields, "wavelengths", set_float(0, -5.0f)),
                   "field wavelengths[0] = -5: must be a number in [1, 1000000] nm");
    expect_refused(changed(fields, "jacobian", [](auto& f) { f.bytes = "\2"; }),
                   "field jacobian must be one value, 0 or 1");
    expect_refused(changed(fields, "luminance",
                           [](auto& f) {
                               f.shape = {5, 4, 1, 25};
                           }),
                   "field luminance has 1 x 25 points: must be square");
}

TEST(RglFile, TooManyWavelengthsAreRefused) {
    bsdf::RglTable table = random_table(0, false);
    table.wavelengths.clear();
    for (std::size_t i = 0; i <= bsdf::kMaxRglWavelengths; ++i) {
        table.wavelengths.push_back(400 + 0.1f * static_cast<float>(i));
    }
    table.spectra.assign(table.slices() * table.channels() * 25, 0.5f);
    EXPECT_THAT([&] { bsdf::validate(table); },
                ::testing::ThrowsMessage<DomainError>(
                    HasSubstr("wavelengths has 4097 values: must have at most 4096")));
}

TEST(RglFile, SizesThatNoFileCanHoldAreRefusedBeforeAnythingIsAllocated) {
    const std::string bytes = rgl_bytes(random_table(0, true));
    // The first size of the first field follows its name, rank, type and offset.
    const std::size_t at = 18 + 2 + std::strlen("description") + 2 + 1 + 8;
    for (const std::uint64_t size :
         {std::uint64_t{1} << 62, ~std::uint64_t{0}, std::uint64_t{1} << 30}) {
        std::string broken = bytes;
        std::memcpy(broken.data() + at, &size, sizeof size);
        expect_refused(broken, "description has more values");
    }
    std::string broken = bytes;
    const std::uint32_t fields = 4'000'000'000;
    std::memcpy(broken.data() + 14, &fields, sizeof fields);
    expect_refused(broken, "has 4000000000 fields: must be at most");
    broken = bytes;
    broken[12] = 2;
    expect_refused(broken, "has version 2.0 of the format: must be 1.0");
}

// Paints that have been through a file of a measured BRDF.

struct Paint {
    std::vector<double> wavelengths_nm = {450, 550, 650};
    measure::Brdf brdf;
};

Paint gold(double alpha) {
    const paint::Recipe recipe =
        nacre::test::metallic(alpha, spectra::Spectrum({450.0, 650.0}, {0.3, 0.8}));
    Paint paint;
    const auto solved =
        std::make_shared<const solver::SolvedPaint>(solver::solve(recipe, paint.wavelengths_nm));
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
    for (const auto& [alpha, flux, peak] : {std::tuple{0.1, 0.003, 0.03}, {0.3, 0.003, 0.03}}) {
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

TEST(MeasuredFiles, StopWhileTheyAreMadeAndRead) {
    const Progress always = [](double) { return true; }, never = [](double) { return false; };
    SharedProgress stopped(never, 1);
    stopped.add(0);
    const bsdf::RglTable rgl = random_table(1, false);
    EXPECT_EQ(rgl_bytes(rgl, always), rgl_bytes(rgl));
    EXPECT_THROW(rgl_bytes(rgl, never), Stopped);
    EXPECT_THROW(bsdf::MeasuredRgl(rgl, &stopped), Stopped);
    bsdf::MerlTable merl{4, 4, 4, {}};
    merl.values.assign(3 * merl.cells(), 0.5);
    EXPECT_EQ(merl_bytes(merl, always), merl_bytes(merl));
    EXPECT_THROW(merl_bytes(merl, never), Stopped);
    EXPECT_THROW(bsdf::MeasuredMerl(merl, &stopped), Stopped);
}

}  // namespace
}  // namespace nacre::io
