#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <stdexcept>

// One file per command. Each adds its options to the program and hands back what to run once the
// command line has been read.

namespace nacre::cli {

/// What the shell is told.
enum class ExitStatus {
    ok = 0,
    usage = 1,              ///< the command line is wrong
    bad_input = 2,          ///< a file, or a value in it, is wrong
    failure = 3,            ///< something failed while running
    comparison_failed = 4,  ///< pictures differ by more than was allowed
};

struct Command {
    CLI::App* options = nullptr;
    std::function<ExitStatus()> run;
};

Command add_film(CLI::App& program);
Command add_solve(CLI::App& program);
Command add_eval(CLI::App& program);
Command add_reference(CLI::App& program);
Command add_render(CLI::App& program);
Command add_diff(CLI::App& program);
Command add_info(CLI::App& program);
Command add_study(CLI::App& program);
Command add_measure(CLI::App& program);  ///< multi-angle colour
Command add_sparkle(CLI::App& program);  ///< sparkle and graininess
Command add_atlas(CLI::App& program);    ///< colours of a film by thickness and angle
Command add_panel(CLI::App& program);    ///< a page about a paint
Command add_fit(CLI::App& program);      ///< from colour back to composition
Command add_export(CLI::App& program);   ///< formats of measured BRDFs

}  // namespace nacre::cli
