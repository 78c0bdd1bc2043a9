#include <CLI/CLI.hpp>
#include <memory>

#include "apps/cli/options.h"
#include "apps/datasheet/catalogue.h"
#include "nacre/core/parallel.h"

namespace nacre::cli {

Command add_materials(CLI::App& program) {
    auto options = std::make_shared<CommonOptions>();
    CLI::App* materials = program.add_subcommand(
        "materials", "The optical constants that ship: ranges, indices, colours, sources");
    add_table_output(*materials, *options);
    materials->footer(
        "Writes CSV: name,from_nm,to_nm,n_550,k_550,chip,source. Without a range the index is one\n"
        "constant. The chip is the colour of a polished, thick piece in air seen head on, under "
        "D65\n"
        "for the observer of 10 deg, with the last index where the data end within 400 to 700 "
        "nm.\n\n"
        "Example:\n"
        "  nacre materials -o materials.csv");
    return {materials, [options] { return files_of(*options, {}, "CSV"); },
            [options] {
                emit_table(*options, datasheet::materials_csv());
                return ExitStatus::ok;
            }};
}

Command add_pigments(CLI::App& program) {
    auto options = std::make_shared<CommonOptions>();
    CLI::App* pigments = program.add_subcommand(
        "pigments", "The pigments that ship: ranges, colours over black and white, sources");
    add_table_output(*pigments, *options);
    add_threads(*pigments, *options);
    pigments->footer(
        "A recipe names one by `from` in [[layer.pigment]] and says how much of it there is.\n\n"
        "Writes CSV: name,title,kind,from_nm,to_nm,over_black,over_white,source. The colours are\n"
        "those of 40 um with 3 % of the pigment by volume over black and over white, read at 45:0\n"
        "under D65 for the observer of 10 deg, with the last index of the material where its data "
        "end.\n\n"
        "Example:\n"
        "  nacre pigments -o pigments.csv");
    return {pigments, [options] { return files_of(*options, {}, "CSV"); },
            [options] {
                const ThreadLimit threads(options->threads);
                emit_table(*options, datasheet::pigments_csv());
                return ExitStatus::ok;
            }};
}

}  // namespace nacre::cli
