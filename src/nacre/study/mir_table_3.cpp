#include "nacre/study/mir_parts.h"

// Table 3: what each model can show, from the models' own description of themselves.

namespace nacre::study {

void add_table_3(MirContext& context) {
    context.report.heading(1, "Table 3: what the models can show", "table-3");
    report::Table table{.columns = {"model", "after", "what it is", "goniochromism", "sparkle",
                                    "multiple scattering"}};
    const auto cell = [](bool can) {
        return report::Cell{.text = can ? "yes" : "no", .strong = can};
    };
    for (const models::ModelInfo& model : models::all_models()) {
        const models::Capabilities& can = model.can;
        table.rows.push_back({{"`" + std::string(model.name) + "`"},
                              {std::string(model.source)},
                              {std::string(model.summary)},
                              cell(can.goniochromism),
                              cell(can.sparkle),
                              cell(can.multiple_scattering)});
        context.results["table_3"][std::string(model.name)] = {
            {"goniochromism", can.goniochromism},
            {"sparkle", can.sparkle},
            {"multiple_scattering", can.multiple_scattering},
            {"reference_only", can.reference_only}};
    }
    context.report.table(table);
    context.report.paragraph(
        "The rows come from the program's list of its models; a test measures each entry. The two "
        "walks are references: unbiased, without values to ask for, hence slow to converge.");
}

}  // namespace nacre::study
