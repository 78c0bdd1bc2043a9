// How well and how fast nacre::fit finds hidden recipes back. Not a Google Benchmark: what counts
// is the worst of many different fits, not the mean of one.
//
//   build/bench/fit_suite [REPEATS [PAINT]]        docs/fit.md quotes its table
//
// Each case takes a paint of paints/ as the start. The hidden recipe has the free numbers drawn
// evenly from the middle nine tenths of their default bounds, on average 1.7 times away from the
// start; its colours at the six angles of byk-mac, exact, are the standard.

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <string>
#include <vector>

#include "nacre/core/estimate.h"
#include "nacre/core/file.h"
#include "nacre/core/random.h"
#include "nacre/fit/fit.h"
#include "nacre/io/recipe_file.h"
#include "nacre/measure/instrument.h"
#include "nacre/solver/solver.h"
#include "nacre/spectra/spectrum.h"

namespace {

using namespace nacre;

struct Case {
    const char* paint;
    std::vector<std::string> free;
};

const Case kCases[] = {
    {"tio2-mica-80", {"coats[0].thickness_nm"}},
    {"red-gold", {"coats[0].thickness_nm"}},
    {"metallic-silver", {"volume_fraction", "orientation.alpha"}},
    {"tio2-mica-110", {"coats[0].thickness_nm", "coats[0].spread_nm", "orientation.alpha"}},
    {"candy-red", {"clearcoat.absorption_per_mm.max", "volume_fraction", "orientation.alpha"}},
    {"solid-red", {"scattering_per_mm.max", "pigment[0].absorption_per_mm.max", "anisotropy"}},
    {"flip-flop",
     {"coats[0].thickness_nm", "coats[1].thickness_nm", "volume_fraction", "orientation.alpha"}},
    {"green-violet",
     {"coats[0].thickness_nm", "coats[0].spread_nm", "coats[1].thickness_nm", "volume_fraction",
      "orientation.alpha"}},
    {"white-pearl",
     {"layer[0].flakes[0].coats[0].thickness_nm", "volume_fraction", "orientation.alpha",
      "layer[1].pigment[0].scattering_per_mm", "layer[1].pigment[0].absorption_per_mm.max"}},
    {"ruby",
     {"flakes[0].coats[0].thickness_nm", "flakes[0].volume_fraction", "flakes[0].orientation.alpha",
      "flakes[1].volume_fraction", "flakes[1].orientation.alpha",
      "pigment[0].absorption_per_mm.max"}},
};

measure::Measurement colours_of(const paint::Recipe& recipe) {
    const solver::SolvedPaint paint = solver::solve(recipe, spectra::default_wavelengths_nm());
    return measure::measure(recipe.name,
                            [&](double theta_i, double theta_o, double phi) {
                                return paint.brdf(theta_i, theta_o, phi);
                            },
                            paint.wavelengths_nm(),
                            measure::find_geometry_set("byk-mac")->geometries, {});
}

}  // namespace

int main(int argc, char** argv) {
    const int repeats = argc > 1 ? std::max(1, std::atoi(argv[1])) : 3;
    std::vector<double> means, seconds;
    fmt::print("{:<18}{:>8}{:>12}{:>12}{:>14}{:>10}{:>8}{:>8}{:>8}\n", "paint", "numbers",
               "dE start", "dE fitted", "worst number", "seconds", "cpu s", "solves", "other");
    for (const Case& one : kCases) {
        if (argc > 2 && std::string(argv[2]) != one.paint) continue;
        const paint::Recipe start =
            io::read_recipe(shipped_file(fmt::format("paints/{}.toml", one.paint)));
        std::vector<std::string> keys;
        for (const std::string& name : one.free) {
            const auto found = paint::matching_parameters(start, name);
            keys.insert(keys.end(), found.begin(), found.end());
        }
        const fit::FreeNumbers numbers(start, keys, {});
        for (int repeat = 0; repeat < repeats; ++repeat) {
            Rng rng(2026, static_cast<std::uint64_t>(repeat));
            std::vector<double> hidden;
            for (std::size_t i = 0; i < numbers.size(); ++i) {
                hidden.push_back(0.05 + 0.9 * rng.uniform_double());
            }
            const measure::Measurement standard = colours_of(numbers.at(hidden));
            const std::clock_t before = std::clock();
            const fit::Fit found = fit::fit(standard, numbers);
            const double cpu = static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC;
            double worst = 0;  // error as a fraction of the bounds
            for (std::size_t i = 0; i < numbers.size(); ++i) {
                worst = std::max(
                    worst, std::abs(numbers[i].to_unit(found.parameters[i].value) - hidden[i]));
            }
            means.push_back(found.difference.mean_delta_e_2000);
            seconds.push_back(found.effort.seconds);
            fmt::print("{:<18}{:>8}{:>12.2f}{:>12.5f}{:>13.3f}%{:>10.2f}{:>8.2f}{:>8}{:>8}\n",
                       one.paint, keys.size(), found.at_start.mean_delta_e_2000,
                       found.difference.mean_delta_e_2000, 100 * worst, found.effort.seconds, cpu,
                       found.effort.solves, found.alternatives.size());
            std::fflush(stdout);
        }
    }
    fmt::print(
        "\n{} fits: mean Delta E 2000 median {:.5f}, worst {:.5f}; seconds median {:.2f}, "
        "worst {:.2f}\n",
        means.size(), median(means), *std::max_element(means.begin(), means.end()), median(seconds),
        *std::max_element(seconds.begin(), seconds.end()));
    return 0;
}
