#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <exception>
#include <new>
#include <string>
#include <vector>

#include "apps/cli/options.h"
#include "nacre/core/error.h"
#include "nacre/core/version.h"
#include "nacre/nacre.h"

namespace {

using nacre::cli::ExitStatus;

ExitStatus run(const std::vector<nacre::cli::Command>& commands) {
    const auto complain = [](const char* what) { fmt::print(stderr, "nacre: {}\n", what); };
    try {
        for (const nacre::cli::Command& command : commands) {
            if (command.options->parsed()) return command.run();
        }
        return ExitStatus::usage;
    } catch (const nacre::cli::UsageError& error) {
        complain(error.what());
        return ExitStatus::usage;
    } catch (const nacre::SettingError& error) {  // options are called like the settings
        complain((std::string("--") + error.what()).c_str());
        return ExitStatus::usage;
    } catch (const nacre::InputError& error) {
        complain(error.what());
        return ExitStatus::bad_input;
    } catch (const nacre::DomainError& error) {
        complain(error.what());
        return ExitStatus::bad_input;
    } catch (const std::bad_alloc&) {
        complain("out of memory");
        return ExitStatus::failure;
    } catch (const std::exception& error) {
        complain(error.what());
        return ExitStatus::failure;
    }
}

}  // namespace

int main(int argc, char** argv) {
    CLI::App program{
        "Nacre predicts and renders the look of special-effect coatings from their composition.",
        "nacre"};
    program.set_version_flag("--version", std::string("nacre ") + nacre::version());
    program.require_subcommand(1);
    program.footer(
        "Exit status: 0 done, 1 wrong usage, 2 bad input, 3 failure while running, 4 a comparison "
        "failed.\n\"nacre COMMAND --help\" documents each command.");
    const std::vector<nacre::cli::Command> commands = {
        nacre::cli::add_film(program),    nacre::cli::add_solve(program),
        nacre::cli::add_eval(program),    nacre::cli::add_reference(program),
        nacre::cli::add_render(program),  nacre::cli::add_diff(program),
        nacre::cli::add_sparkle(program), nacre::cli::add_study(program),
        nacre::cli::add_info(program),    nacre::cli::add_measure(program),
        nacre::cli::add_atlas(program),   nacre::cli::add_export(program),
        nacre::cli::add_panel(program),   nacre::cli::add_fit(program)};
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        // exit() prints help, version or the complaint, and returns 0 for the first two.
        return static_cast<int>(program.exit(error) == 0 ? ExitStatus::ok : ExitStatus::usage);
    }
    return static_cast<int>(run(commands));
}
