#include "nacre/spectra/observer.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "nacre/core/error.h"
#include "nacre/core/file.h"

namespace nacre::spectra {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::ThrowsMessage;

std::vector<std::vector<double>> read_table(const std::string& name) {
    std::ifstream file(data_file(name));
    std::vector<std::vector<double>> rows;
    std::string line, cell;
    std::getline(file, line);  // header
    while (std::getline(file, line)) {
        rows.emplace_back();
        std::istringstream cells(line);
        while (std::getline(cells, cell, ',')) rows.back().push_back(std::stod(cell));
    }
    return rows;
}

TEST(Observers, AreThoseOfTheDataFolder) {
    const auto rows = read_table("cie_observers.csv");
    ASSERT_EQ(rows.size(), 95u);
    for (const auto& row : rows) {
        ASSERT_EQ(row.size(), 7u);
        const Vec3d small = colour_matching(Observer::cie1931_2deg, row[0]);
        const Vec3d large = colour_matching(Observer::cie1964_10deg, row[0]);
        for (int c = 0; c < 3; ++c) {
            EXPECT_EQ(small[c], row[1 + c]) << row[0];
            EXPECT_EQ(large[c], row[4 + c]) << row[0];
        }
    }
}

TEST(Illuminants, AreThoseOfTheDataFolderAndZeroWhereNoneArePublished) {
    const auto rows = read_table("cie_illuminants.csv");
    ASSERT_EQ(rows.size(), 85u);
    int missing = 0;
    for (const auto& row : rows) {
        ASSERT_EQ(row.size(), 6u);
        for (int k = 0; k < 5; ++k) {
            const double power = illuminant_power(static_cast<Illuminant>(k), row[0]);
            missing += std::isnan(row[1 + k]);
            EXPECT_EQ(power, std::isnan(row[1 + k]) ? 0 : row[1 + k]) << row[0] << " " << k;
        }
    }
    EXPECT_EQ(missing, 8);  // FL2 and FL11 at 360 to 375 nm
}

TEST(Observers, AreLinearBetweenSamplesAndZeroOutside) {
    const Vec3d a = colour_matching(Observer::cie1931_2deg, 550);
    const Vec3d b = colour_matching(Observer::cie1931_2deg, 555);
    const Vec3d between = colour_matching(Observer::cie1931_2deg, 552);
    const Vec3d none = {0, 0, 0};
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(between[c], 0.6 * a[c] + 0.4 * b[c], 1e-15);
    for (double outside : {-1.0, 359.9, 830.1, 1e300}) {
        EXPECT_EQ(colour_matching(Observer::cie1964_10deg, outside), none);
    }
    EXPECT_GT(colour_matching(Observer::cie1931_2deg, 830)[0], 0);
    EXPECT_THROW(colour_matching(Observer::cie1931_2deg, std::nan("")), DomainError);
}

TEST(Illuminants, EndWhereTheirDataEnd) {
    EXPECT_EQ(illuminant_power(Illuminant::D65, 560), 100);
    EXPECT_EQ(illuminant_power(Illuminant::A, 359.9), 0);
    EXPECT_EQ(illuminant_power(Illuminant::A, 780.1), 0);
    EXPECT_EQ(illuminant_power(Illuminant::FL2, 377), 0);
    EXPECT_EQ(illuminant_power(Illuminant::FL2, 380), 1.18);
    EXPECT_EQ(illuminant_power(Illuminant::E, 1000), 100);
    EXPECT_THROW(illuminant_power(Illuminant::E, std::nan("")), DomainError);
}

// Illuminant A is a law as well as a table: Planck's at c2 / T = 1.435e7 / 2848 nm, relative to
// 560 nm [cie-15-2018]; the table rounds to six digits.
TEST(Illuminants, AFollowsPlancksLaw) {
    const auto planck = [](double nm) {
        return 100 * std::pow(560 / nm, 5) * std::expm1(1.435e7 / (2848 * 560)) /
               std::expm1(1.435e7 / (2848 * nm));
    };
    for (double nm = 360; nm <= 780; nm += 5) {
        EXPECT_NEAR(illuminant_power(Illuminant::A, nm) / planck(nm), 1, 2e-5) << nm;
    }
}

TEST(Names, OfObserversMayHaveTheirUnit) {
    for (const std::string unit : {"", "deg", " deg.", " degree", "degree", " Degrees", "_Degree",
                                   " Grad", "\u00b0", " \u00b0", " "}) {
        EXPECT_EQ(parse_observer("2" + unit), Observer::cie1931_2deg) << unit;
        EXPECT_EQ(parse_observer("10" + unit), Observer::cie1964_10deg) << unit;
    }
    for (const char* text : {"1931", "", "degree", "1 0", "12 degree", "10 mm", "10degre", "-10"}) {
        EXPECT_THAT([&] { parse_observer(text); },
                    ThrowsMessage<InputError>(HasSubstr("observer '" + std::string(text) +
                                                        "' is unknown; use 2 (CIE 1931) or 10")));
    }
}

TEST(Names, AreReadStrictlyAndErrorsHelp) {
    EXPECT_EQ(parse_illuminant("A"), Illuminant::A);
    EXPECT_EQ(parse_illuminant("D50"), Illuminant::D50);
    EXPECT_EQ(parse_illuminant("D65"), Illuminant::D65);
    EXPECT_EQ(parse_illuminant("FL2"), Illuminant::FL2);
    EXPECT_EQ(parse_illuminant("FL11"), Illuminant::FL11);
    EXPECT_EQ(parse_illuminant("E"), Illuminant::E);
    EXPECT_THAT([] { parse_illuminant("D6"); },
                ThrowsMessage<InputError>(
                    AllOf(HasSubstr("D6"), HasSubstr("did you mean 'D65'"), HasSubstr("FL11"))));
    EXPECT_THROW(parse_illuminant(""), InputError);
}

TEST(Names, AreWrittenAsTheyAreRead) {
    for (const char* text : {"A", "D50", "D65", "FL2", "FL11", "E"}) {
        EXPECT_EQ(name(parse_illuminant(text)), text);
    }
    for (const char* text : {"2", "10"}) EXPECT_EQ(name(parse_observer(text)), text);
}

}  // namespace
}  // namespace nacre::spectra
