#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "nacre/bsdf/measured/merl.h"
#include "nacre/bsdf/wavelength_lanes.h"
#include "nacre/core/error.h"
#include "nacre/core/random.h"
#include "nacre/io/measured_brdf_file.h"
#include "nacre/testing/bsdf.h"
#include "nacre/testing/errors.h"

namespace nacre::io {
namespace {

using bsdf::direction;
using nacre::test::message_of;

bsdf::MerlTable random_table(int half, int difference, int azimuths) {
    bsdf::MerlTable table{half, difference, azimuths, {}};
    Rng rng(5, 1);
    for (std::size_t i = 0; i < 3 * table.cells(); ++i) {
        table.values.push_back(rng.uniform_double() - 0.1);
    }
    return table;
}

/// Values of sine_table() by an independent program: numpy 2.4.6 and scipy 1.17.1, half and
/// difference angles by rotation matrices as the database's reading code has them
/// [matusik-2003; rusinkiewicz-1998], then
///     scipy.interpolate.RegularGridInterpolator((half + 1/2, difference + 1/2, azimuth + 1/2),
///     ...)
/// with one more azimuth at either end, theta_half as 9 sqrt(theta_half / 90 deg).
struct Lookup {
    double theta_i, phi_i, theta_o, phi_o;  ///< deg
    float rgb[3];                           ///< 1/sr
};
const Lookup kLinear[] = {
    {20, 30, 35, 200, {1.063326f, 1.329192f, 0.8396091f}},
    {50, -70, 10, 15, {0.9357547f, 0.6660083f, 1.134471f}},
    {70, 100, 60, -60, {0.8562256f, 1.387886f, 1.176042f}},
    {5, -160, 80, 120, {0.7048138f, 0.5073167f, 1.537716f}},
    {85, 10, 40, -170, {0.5603484f, 0.4752625f, 1.781545f}},
    {45, 0, 45.5, 180, {1.034546f, 0.8123258f, 0.9521444f}},
};
/// The cell itself, by rounding down as the database's reading code does, at middles of cells.
const Lookup kNearest[] = {
    {40.7708102, 137.421191, 38.9813085, -25.9485815, {0.6267981f, 1.668288f, 1.521758f}},
    {13.534558, 112.058233, 37.2533852, 46.0521254, {1.257665f, 1.4541f, 0.5013557f}},
    {78.1258056, 119.39266, 54.59108, -28.3898075, {0.3874275f, 0.3389407f, 2.085674f}},
    {75.6038773, 70.4345654, 70.6466872, -109.367119, {0.1479411f, 0.7930824f, 2.42632f}},
};

bsdf::MerlTable sine_table() {
    bsdf::MerlTable table{9, 8, 12, {}};
    for (std::size_t i = 0; i < 3 * table.cells(); ++i) {
        table.values.push_back(1000 * (1.2 + std::sin(0.7 * static_cast<double>(i))));
    }
    return table;
}

TEST(MerlFile, IsLookedUpAsAnIndependentProgramDoes) {
    const bsdf::Wavelengths wavelengths = {410, 450, 490, 530, 570, 610, 650, 690};
    const bsdf::MeasuredMerl model(parse_merl(merl_bytes(sine_table()), "sine.binary"));
    const auto bound = model.bind(wavelengths);
    const auto compare = [&](const Lookup& at) {
        const FloatLanes f =
            bound->eval(direction(at.theta_i, at.phi_i), direction(at.theta_o, at.phi_o));
        const FloatLanes wanted = bsdf::RgbLanes(wavelengths)({at.rgb[0], at.rgb[1], at.rgb[2]});
        // Seven digits there; angles in single precision here, over slopes of 3 per cell.
        for (int i = 0; i < kLanes; ++i) EXPECT_NEAR(f[i], wanted[i], 3e-5) << at.theta_i;
    };
    for (const Lookup& at : kLinear) compare(at);
    for (const Lookup& at : kNearest) compare(at);
}

void expect_merl_refused(const std::string& bytes, const std::string& message) {
    EXPECT_FALSE(looks_like_merl(bytes) && message.find("must") == std::string::npos);
    EXPECT_THAT(message_of<InputError>([&] { parse_merl(bytes, "broken.binary"); }),
                ::testing::HasSubstr("broken.binary: " + message));
}

TEST(MerlFile, WriteReadWriteGivesTheSameBytes) {
    const bsdf::MerlTable table = random_table(5, 4, 6);
    const std::string bytes = merl_bytes(table);
    EXPECT_EQ(bytes.size(), 12u + 8 * 3 * 5 * 4 * 6);
    EXPECT_TRUE(looks_like_merl(bytes));
    const bsdf::MerlTable back = parse_merl(bytes, "a.binary");
    EXPECT_EQ(back, table);
    EXPECT_EQ(merl_bytes(back), bytes);
}

TEST(MerlFile, ChannelsFollowEachOtherWithThePhiOfACellFastest) {
    bsdf::MerlTable table = random_table(5, 4, 6);
    const std::string bytes = merl_bytes(table);
    // [published layout: index = phi + theta_d * phis + theta_h * theta_ds * phis, red first]
    const std::size_t index = 3 + 2 * 6 + 4 * 4 * 6, green = 5 * 4 * 6;
    double value;
    std::memcpy(&value, bytes.data() + 12 + 8 * (index + green), sizeof value);
    EXPECT_EQ(value, table.values[table.cells() + table.cell(4, 2, 3)]);
}

TEST(MerlFile, EveryPieceOfAFileIsRefused) {
    const std::string bytes = merl_bytes(random_table(2, 3, 2));
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        const std::string_view piece = std::string_view(bytes).substr(0, size);
        EXPECT_FALSE(looks_like_merl(piece));
        EXPECT_THROW(parse_merl(piece, "a.binary"), InputError);
    }
}

TEST(MerlFile, ErrorsNameTheValueAndWhatIsAllowed) {
    const std::string bytes = merl_bytes(random_table(2, 3, 2));
    std::string broken = bytes;
    const std::int32_t many = 2'000'000'000;
    std::memcpy(broken.data(), &many, sizeof many);
    expect_merl_refused(broken, "has 2000000000 x 3 x 2 cells: must have 2 to 1024 along each");
    expect_merl_refused(bytes + "x", "has 301 bytes: 2 x 3 x 2 cells must have 300");
    broken = bytes;
    const double nan = std::nan("");
    std::memcpy(broken.data() + 12 + 8 * 7, &nan, sizeof nan);
    expect_merl_refused(broken, "value 7 is nan: must be a number in [-1e30, 1e30]");
}

}  // namespace
}  // namespace nacre::io
