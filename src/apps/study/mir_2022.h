#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>

#include "apps/report/report.h"
#include "apps/study/gallery.h"
#include "apps/study/mir_printed.h"

namespace nacre::study {

/// The parts of the comparison. A figure shows the pictures that a table counts: Figure 2 belongs
/// to Table 1, 3 to 2, 4 to 4.
enum class MirPart {
    table_1,       ///< reference, raw and compressed tables of two paints; with Figure 2
    table_2,       ///< facets, flakes and time; with Figure 3
    table_3,       ///< what the models can do
    table_4,       ///< the models on two pearls; with Figure 4
    agreement,     ///< three solutions of one paint, pixel by pixel
    quality,       ///< time to a picture of a given quality; a query of each model
    antialiasing,  ///< spectral antialiasing against integration
    nacre          ///< what the model that the paper asks for costs, and how it errs
};

std::set<MirPart> all_mir_parts();

struct MirSettings {
    std::filesystem::path folder;
    int size = printed::kPictureSize;  ///< pixels a side, [16, 4096]
    int samples = printed::kSamples;   ///< per pixel, [8, 2^20]
    std::uint64_t seed = 0;
    bool quick = false;  ///< smaller tables, fewer curves: to see that all works
    std::set<MirPart> parts = all_mir_parts();
};

/// @throws DomainError naming a setting out of range
void require_valid(const MirSettings& settings);

/// Reproduces the comparison of Mir, Yildirim and Kurt [mir-2022]: renders what is not yet in
/// `folder`, and writes index.html (one self-contained page) and results.json (every figure) there.
///
/// @return the page
/// @throws DomainError naming a setting out of range; Interrupted; what solving and rendering throw
std::filesystem::path run_mir_2022(const MirSettings& settings, const Stage& stage);

// The parts of the study, one file each. Each renders what it needs, adds a section to the report
// and its figures to the results.

inline constexpr double kBallRadius_mm = 50;  ///< of the built-in scene

using models::named_model;

struct MirContext {
    const MirSettings& settings;
    const Gallery& gallery;
    report::Report& report;
    nlohmann::json& results;

    /// Adds a table to the page and to the results, from where the documentation takes it
    /// (mir_document.h).
    void table(const std::string& name, const report::Table& table);

    /// A picture at the study's size and samples.
    PictureJob job(std::string key, std::string title, const std::string& paint,
                   bsdf::Model model) const;
};

/// A row of Figure 4 and Table 4 as printed: flakes for the model of Ergun et al., a set of Table 2
/// for those of Belcour and Barla and of Guo et al.
struct MirFigure4Row {
    const char* flakes_name;
    const char* flakes;  ///< shipped recipe
    const char* facets_name;
    const char* facets;
    printed::ModelTimes paper;
};
inline constexpr MirFigure4Row kFigure4Rows[] = {
    {"80 nm of TiO₂", "paints/tio2-mica-80.toml", "570 nm", "studies/mir-2022/facets-570.toml",
     printed::kTable4[0]},
    {"110 nm of TiO₂", "paints/tio2-mica-110.toml", "665 nm", "studies/mir-2022/facets-665.toml",
     printed::kTable4[1]}};

void add_table_1(MirContext& context);
void add_table_2(MirContext& context);
void add_table_3(MirContext& context);
void add_table_4(MirContext& context);
void add_agreement(MirContext& context);
void add_quality(MirContext& context);
void add_antialiasing(MirContext& context);
void add_nacre(MirContext& context);

/// Parts of add_nacre().
void add_cost_by_number(MirContext& context);
void add_query_costs(MirContext& context);
void add_equal_time_errors(MirContext& context);

/// "0.031" and the like: `digits` significant ones.
std::string number(double value, int digits = 3);
/// 10⁷ for the nearest power of ten; value >= 1.
std::string power_of_ten(double value);
/// 3.2 s, 1:05.
std::string duration(double seconds);
std::string mebibytes(std::size_t bytes);

}  // namespace nacre::study
