#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "apps/cli/options.h"
#include "nacre/io/image_difference.h"

namespace nacre::cli {

namespace {

struct DiffOptions : CommonOptions {
    std::string a, b;
    double heat_full_scale = 10;
    std::optional<double> min_psnr, max_relative, max_delta_e_mean, max_delta_e_95th;
};

bool is_exr_name(const std::string& output) {
    const std::string extension = std::filesystem::path(output).extension();
    if (extension == ".exr") return true;
    if (extension == ".png") return false;
    throw UsageError(fmt::format("--output = {}: must end in .exr or .png", output));
}

/// The difference picture: signed numbers in an EXR, a heat map of Delta E in a PNG.
void write_difference(const DiffOptions& options, const io::ImageDifference& difference) {
    if (options.output.empty()) return;
    if (is_exr_name(options.output)) {
        io::write_exr(options.output, difference.picture);
    } else {
        io::write_png(options.output, io::difference_heat_map(difference, options.heat_full_scale));
    }
}

/// Whether the difference stays within every bound that was given.
bool is_within_bounds(const DiffOptions& options, const io::ImageDifference& d) {
    const auto within = [](double value, const std::optional<double>& bound, const char* name) {
        if (!bound || value <= *bound) return true;
        print_message(fmt::format("nacre: {} = {:.6g} is more than {}", name, value, *bound));
        return false;
    };
    bool ok = within(d.relative_error, options.max_relative, "relative error");
    ok &= within(d.delta_e_mean, options.max_delta_e_mean, "mean Delta E 2000");
    ok &= within(d.delta_e_95th, options.max_delta_e_95th, "95th percentile of Delta E 2000");
    if (options.min_psnr && d.psnr_db < *options.min_psnr) {
        print_message(
            fmt::format("nacre: PSNR = {:.6g} dB is less than {}", d.psnr_db, *options.min_psnr));
        ok = false;
    }
    return ok;
}

/// Of pictures that tell their standard errors: more lines of the table.
std::string z_score_lines(const io::ImageZScores& z) {
    return fmt::format(
        "z_values,{}\nz_mean_square,{:.6g}\nz_mean_square_expected,{:.6g}\nz_above_3,{:.6g}\n"
        "z_above_3_expected,{:.6g}\nz_of_mean,{:.6g}\nz_unexplained,{}\n",
        z.values, z.mean_square, z.expected_mean_square, z.fraction_above_3,
        z.expected_fraction_above_3, z.of_mean, z.unexplained);
}

nlohmann::json z_score_json(const io::ImageZScores& z) {
    nlohmann::json json = {{"channels", z.channels},
                           {"standard_error_of_a", z.has_error_a},
                           {"standard_error_of_b", z.has_error_b},
                           {"values", z.values},
                           {"mean_square", z.mean_square},
                           {"above_3", z.fraction_above_3},
                           {"above_3_expected", z.expected_fraction_above_3},
                           {"of_mean", z.of_mean},
                           {"unexplained", z.unexplained}};
    if (std::isfinite(z.expected_mean_square)) {
        json["mean_square_expected"] = z.expected_mean_square;
    }
    return json;
}

ExitStatus run(const DiffOptions& options) {
    if (!options.output.empty()) is_exr_name(options.output);  // before any work
    const io::Image b = io::read_image(options.b), a = io::read_image(options.a);
    const io::ImageDifference d = io::image_difference(a, b, options.a, options.b);
    const auto z = io::image_z_scores(a, b, options.a, options.b);
    write_difference(options, d);
    const std::string csv = fmt::format(
        "quantity,value\nmse,{:.9g}\npsnr_db,{:.6g}\nrelative_error,{:.9g}\n"
        "delta_e_2000_mean,{:.6g}\ndelta_e_2000_95th_percentile,{:.6g}\ndelta_e_2000_max,{:.6g}\n",
        d.mean_square_error, d.psnr_db, d.relative_error, d.delta_e_mean, d.delta_e_95th,
        d.delta_e_max);
    print_data(table_text(options, csv + (z ? z_score_lines(*z) : "")));
    const bool ok = is_within_bounds(options, d);
    nlohmann::json report = {{"a", options.a},
                             {"b", options.b},
                             {"mse", d.mean_square_error},
                             {"relative_error", d.relative_error},
                             {"delta_e_2000_mean", d.delta_e_mean},
                             {"delta_e_2000_95th_percentile", d.delta_e_95th},
                             {"delta_e_2000_max", d.delta_e_max},
                             {"within_bounds", ok}};
    if (z) report["z_scores"] = z_score_json(*z);
    if (std::isfinite(d.psnr_db)) report["psnr_db"] = d.psnr_db;  // JSON has no infinity
    write_report(options, "diff", std::move(report));
    return ok ? ExitStatus::ok : ExitStatus::comparison_failed;
}

}  // namespace

Command add_diff(CLI::App& program) {
    auto options = std::make_shared<DiffOptions>();
    CLI::App* diff = program.add_subcommand("diff", "Compare two pictures");
    diff->add_option("A", options->a, "Picture: OpenEXR, Radiance HDR or PNG")->required();
    diff->add_option("B", options->b, "Picture to compare with, the reference")->required();
    diff->add_option("-o,--output", options->output,
                     "Picture of the difference: .exr (A - B and Delta E) or .png (heat map)")
        ->type_name("FILE");
    diff->add_option("--heat-full-scale", options->heat_full_scale,
                     "Delta E that is white in the heat map")
        ->check(in_range(1e-6, 1e6))
        ->capture_default_str();
    diff->add_option("--min-psnr", options->min_psnr, "Fail below this PSNR, dB");
    diff->add_option("--max-relative", options->max_relative, "Fail above this relative error");
    diff->add_option("--max-delta-e-mean", options->max_delta_e_mean,
                     "Fail above this mean Delta E 2000");
    diff->add_option("--max-delta-e-95", options->max_delta_e_95th,
                     "Fail above this 95th percentile of Delta E 2000");
    add_table_format(*diff, *options);
    add_report(*diff, *options);
    diff->footer(
        "Writes CSV: quantity,value. Over R, G, B in linear light: mse; psnr_db =\n"
        "10 log10(1 / mse), inf if equal; relative_error, the mean of |a - b| / (|b| + 0.01); and\n"
        "CIEDE2000 under D65, white being the perfect diffuser. Where a picture has channels\n"
        "stderr.NAME, standard errors of NAME (nacre study mir-2022 --references): z-scores, the\n"
        "error of a picture without them being taken as 0. Exit status 4 if a bound given is\n"
        "broken.\n\n"
        "Example:\n  nacre diff new.exr approved.exr --max-delta-e-mean 1 -o difference.png");
    return {diff,
            [options] {
                CommandFiles files = files_of(*options, {options->a, options->b});
                files.prints = true;
                return files;
            },
            [options] { return run(*options); }};
}

}  // namespace nacre::cli
