#pragma once

#include <CLI/CLI.hpp>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "apps/cli/options.h"
#include "nacre/render.h"

// What `nacre render` and `nacre merge` do with a picture.

namespace nacre::cli {

/// --exposure and --gamut.
void add_tone_map(CLI::App& command, ToneMap& tone_map);
void add_picture_output(CLI::App& command, CommonOptions& options);

/// @throws UsageError if --output does not end in `extension`
void check_extension(const CommonOptions& options, const std::string& extension);

/// Warns of a picture without shapes, and of light that is not in it.
void warn_of_picture(const CommonOptions& options, const render::RenderResult& result,
                     const std::string& scene);

/// "out.exr and out.png: 512 x 512 pixels, 64 samples each, noise 2 %, 3.4 s (4.9 Msamples/s)".
std::string summary(const render::RenderResult& result, const std::filesystem::path& exr);

/// Writes the EXR and the PNG beside it.
/// @return for the end of summary(): how many pixels the PNG's display cannot show, if it matters
std::string write_picture(const std::filesystem::path& exr, io::Image image,
                          const ToneMap& tone_map);

/// What both report of a picture.
nlohmann::json report_of(const render::RenderResult& result, const std::filesystem::path& exr,
                         const ToneMap& tone_map);

/// Of two digits, or more where it is 100 % and more: "0.31 %", "12 %", "114 %".
std::string percent_text(double fraction);

}  // namespace nacre::cli
