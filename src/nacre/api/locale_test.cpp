#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <locale>
#include <sstream>
#include <string>

#include "nacre/core/references.h"
#include "nacre/nacre.h"

// A program that embeds the library may live in a place where 0.5 is written 0,5.

namespace nacre {
namespace {

constexpr const char* kRecipe = R"(ior = 1.5
[[layer]]
thickness_um = 12.5
[[layer.flakes]]
area_density_per_um = 0.125
orientation = { distribution = "beckmann", alpha = 0.15 }
reflectance = 0.625
)";

class DecimalComma : public std::numpunct<char> {
 protected:
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

/// While it lives, streams write 1234.5 as 1.234,5.
class CommaLocale {
 public:
    CommaLocale()
        : before_(std::locale::global(std::locale(std::locale::classic(), new DecimalComma))) {}
    ~CommaLocale() { std::locale::global(before_); }

 private:
    std::locale before_;
};

struct Texts {
    std::string recipe, readings, solved, message;
    friend bool operator==(const Texts&, const Texts&) = default;
};

Texts texts() {
    const Paint paint = open_text(kRecipe, "paint.toml");
    Texts all;
    all.recipe = paint.recipe_sha256();
    all.readings = paint.measure(geometries("45as15,45as-15.5")).csv();
    const Paint again = open_text(all.readings, "readings.csv");
    EXPECT_EQ(again.measure().csv(), all.readings);
    try {
        paint.with("layer[0].thickness_um", -1234.5);
    } catch (const DomainError& error) {
        all.message = error.what();
    }
    return all;
}

TEST(Locale, ChangesNeitherFilesNorMessages) {
    const Texts plain = texts();
    EXPECT_THAT(plain.message, ::testing::HasSubstr("= -1234.5: must be in"));
    const CommaLocale comma;
    std::ostringstream check;
    check << 1234.5;
    ASSERT_EQ(check.str(), "1.234,5");
    EXPECT_EQ(texts(), plain);
}

}  // namespace
}  // namespace nacre
