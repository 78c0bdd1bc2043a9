#include "nacre/study/mir_parts.h"

// What the fourth model costs and how it errs, beside the two that it stands between.

namespace nacre::study {

void add_nacre(MirContext& context) {
    report::Report& report = context.report;
    report.heading(1, "The fourth model: cost and error", "nacre");
    report.paragraph(
        "`nacre` is to show the sparkle of `special-effect` at the price of `microflake`. Three "
        "measurements: what a picture costs by the number of flakes, what one query costs by the "
        "number in its footprint, and how far a picture of a given time is from the converged one. "
        "Models that are compared take turns in one run; times that are compared are processor "
        "times, and medians where they are short, so that what else the machine does matters "
        "little.");
    add_cost_by_number(context);
    add_query_costs(context);
    add_equal_time_errors(context);
}

}  // namespace nacre::study
