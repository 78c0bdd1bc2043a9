#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "nacre/testing/files.h"

// Only for tests: the program, run in a folder of its own.

namespace nacre::cli::testing {

/// A recipe of facets, without layers; [microfacet.facets] may follow.
inline constexpr char kMicrofacetRecipe[] = R"(ior = 1.5
[microfacet]
alpha = 0.2
film_ior = 1.8
film_thickness_nm = 158
base_ior = 1.08
base_extinction = 0.51
)";

// Commands that work on the paint of the test's folder; a blank follows.
inline const std::string kEval = "eval gray.toml --incident 45 --outgoing 0 --wavelength 550 ";
inline const std::string kRender = "render sphere --paint gray.toml --spp 1 --size 2x2 --quiet ";
inline const std::string kAtlas = "atlas --film mica --thickness 100,200 --quiet ";

struct Outcome {
    int status = -1;
    std::string out, err;
};

std::string contents(const std::filesystem::path& path);

/// A glTF file of one triangle, whose corners stand in a file beside.
std::string triangle(const std::string& buffer);
/// Them: nine little-endian floats, (0,0,0), (1,0,0), (0,1,0).
std::string corners();

class Program : public ::testing::Test {
 protected:
    /// Puts a paint into the folder: gray.toml.
    void SetUp() override;

    /// Runs `BEFORE nacre ARGUMENTS` in the test's folder, as in "cat gray.toml |" before.
    Outcome nacre(const std::string& arguments, const std::string& before = "") const;
    /// Runs a shell script there, in which $NACRE is the program.
    Outcome shell(const std::string& script) const;
    void write(const std::string& name, const std::string& text) const;
    bool exists(const std::string& name) const;

    test::TempFolder folder_;
};

/// Cell of a CSV text, row 0 being the header.
std::string cell(const std::string& csv, int row, int column);
double number(const std::string& csv, int row, int column);

}  // namespace nacre::cli::testing
