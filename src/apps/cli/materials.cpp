#include <CLI/CLI.hpp>
#include <memory>

#include "apps/cli/options.h"
#include "apps/datasheet/catalogue.h"

namespace nacre::cli {

Command add_materials(CLI::App& program) {
    auto options = std::make_shared<CommonOptions>();
    CLI::App* materials = program.add_subcommand(
        "materials", "The optical constants that ship: ranges, indices, colours, sources");
    add_output(*materials, *options);
    materials->footer(
        "Writes CSV: name,from_nm,to_nm,n_550,k_550,chip,source. Without a range the index is one\n"
        "constant. The chip is the colour of a polished, thick piece in air seen head on, under "
        "D65\n"
        "for the observer of 10 deg; none where the data do not cover 400 to 700 nm.\n\n"
        "Example:\n"
        "  nacre materials -o materials.csv");
    return {materials, [options] { return files_of(*options, {}); },
            [options] {
                emit(*options, datasheet::materials_csv());
                return ExitStatus::ok;
            }};
}

}  // namespace nacre::cli
