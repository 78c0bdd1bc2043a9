#include "apps/cli/picture_output.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "apps/cli/files.h"
#include "nacre/io/image.h"

namespace nacre::cli {

namespace {

const std::map<std::string, spectra::Gamut> kGamuts{{"rec709", spectra::Gamut::rec709},
                                                    {"display-p3", spectra::Gamut::display_p3},
                                                    {"rec2020", spectra::Gamut::rec2020}};

const std::string& name_of(spectra::Gamut gamut) {
    return std::ranges::find(kGamuts, gamut, [](const auto& named) { return named.second; })->first;
}

double msamples_per_s(const render::RenderResult& result) {
    return static_cast<double>(result.samples) * result.width * result.height / result.seconds /
           1e6;
}

}  // namespace

void add_tone_map(CLI::App& command, ToneMap& tone_map) {
    command
        .add_option("--exposure", tone_map.exposure_stops,
                    "Exposure of the PNG in stops; the EXR is not touched")
        ->check(in_range(io::kExposureRange.lo, io::kExposureRange.hi))
        ->capture_default_str();
    command
        .add_option_function<std::string>(
            "--gamut", [&tone_map](const std::string& name) { tone_map.gamut = kGamuts.at(name); },
            "Display of the PNG: rec709 (sRGB), display-p3 or rec2020, which have purer "
            "colours [rec709]")
        ->check(CLI::IsMember(kGamuts))
        ->type_name("DISPLAY");
}

std::string write_picture(const std::filesystem::path& exr, io::Image image,
                          const ToneMap& tone_map) {
    const double outside = io::outside_gamut(image, tone_map.gamut);
    io::write_exr_and_png(exr, std::move(image), tone_map);
    constexpr double kWorthSaying = 0.01;
    if (outside < kWorthSaying) return {};
    return fmt::format("; {} of the pixels have colours that the PNG's display ({}) does not{}",
                       percent_text(outside), name_of(tone_map.gamut),
                       tone_map.gamut == spectra::Gamut::rec2020 ? "" : ": --gamut has wider ones");
}

void add_picture_output(CLI::App& command, CommonOptions& options) {
    command
        .add_option("-o,--output", options.output, "File to write (.exr); the .png is put beside")
        ->required()
        ->type_name("FILE");
}

void check_extension(const CommonOptions& options, const std::string& extension) {
    if (std::filesystem::path(options.output).extension() == extension) return;
    throw UsageError(
        fmt::format("--output = {}: must end in {}{}", options.output, extension,
                    is_standard_output(options.output)
                        ? "; a picture is two files, which do not go to the standard output"
                        : ""));
}

void warn_of_picture(const CommonOptions& options, const render::RenderResult& result,
                     const std::string& scene) {
    if (std::ranges::all_of(result.alpha, [](float alpha) { return alpha == 0; })) {
        warn(options, fmt::format("{}: the camera sees no shape, only what surrounds the scene; is "
                                  "a mesh of another size (mm_per_unit), or the camera elsewhere?",
                                  scene));
    }
    if (result.invalid_paths > 0) {
        warn(options,
             fmt::format("{}: the light of {} paths is not finite or beyond 2^53 times that of the "
                         "perfect diffuser in full light, and was taken as black",
                         scene, result.invalid_paths));
    }
}

std::string summary(const render::RenderResult& result, const std::filesystem::path& exr) {
    return fmt::format("{} and {}: {} x {} pixels, {} samples each{}, {} ({:.2f} Msamples/s)",
                       exr.string(), io::png_beside(exr).string(), result.width, result.height,
                       result.samples, result.noise ? ", noise " + percent_text(*result.noise) : "",
                       duration_text(result.seconds), msamples_per_s(result));
}

nlohmann::json report_of(const render::RenderResult& result, const std::filesystem::path& exr,
                         const ToneMap& tone_map) {
    return {{"output", {exr.string(), io::png_beside(exr).string()}},
            {"width", result.width},
            {"height", result.height},
            {"samples_per_pixel", result.samples},
            {"noise", result.noise ? nlohmann::json(*result.noise) : nullptr},
            {"exposure_stops", tone_map.exposure_stops},
            {"gamut", name_of(tone_map.gamut)},
            {"complete", result.complete},
            {"render_s", result.seconds},
            {"msamples_per_s", msamples_per_s(result)}};
}

std::string percent_text(double fraction) {
    const double percent = 100 * fraction;
    constexpr double kThreeDigits = 99.5;  // from here two digits would need an exponent
    return percent < kThreeDigits ? fmt::format("{:.2g} %", percent)
                                  : fmt::format("{:.0f} %", percent);
}

}  // namespace nacre::cli
