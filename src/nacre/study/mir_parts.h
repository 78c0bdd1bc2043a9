#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "nacre/report/report.h"
#include "nacre/study/mir_2022.h"

// The parts of the study, one file each. Each renders what it needs, adds a section to the report
// and its figures to the results.

namespace nacre::study {

inline constexpr double kBallRadiusMm = 50;  ///< of the built-in scene

struct MirContext {
    const MirSettings& settings;
    const Gallery& gallery;
    report::Report& report;
    nlohmann::json& results;

    /// A picture at the study's size and samples.
    PictureJob job(std::string key, std::string title, const std::string& paint,
                   models::Model model) const;
};

void add_table_1(MirContext& context);
void add_table_2(MirContext& context);
void add_table_3(MirContext& context);
void add_table_4(MirContext& context);
void add_agreement(MirContext& context);
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
