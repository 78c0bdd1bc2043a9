#include <fcntl.h>
#include <signal.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "apps/cli/command_line.h"
#include "apps/cli/options.h"
#include "nacre/core/error.h"
#include "nacre/core/text.h"
#include "nacre/core/version.h"
#include "nacre/nacre.h"

namespace {

using nacre::cli::ExitStatus;

void complain(const std::string& what) {
    nacre::cli::print_message(nacre::printable("nacre: " + what));
}

/// Files must not become standard input, output or error because these were closed: data would
/// get mixed into them. What stands in for standard output refuses data, so that their loss shows.
void reserve_standard_streams() {
    for (int fd = 0; fd <= 2; ++fd) {
        if (::fcntl(fd, F_GETFD) != -1 || errno != EBADF) continue;
        // Takes the lowest number that is free: fd.
        (void)::open("/dev/null", fd == 1 ? O_RDONLY : O_RDWR);
    }
}

/// What the program would otherwise be killed by in the middle of a file or for a message: a reader
/// that has gone, a file beyond the limit on sizes. Both come back as errors of writing.
class SignalsAsErrors {
 public:
    SignalsAsErrors() : pipe_(::signal(SIGPIPE, SIG_IGN)) { ::signal(SIGXFSZ, SIG_IGN); }
    /// Ends the program as a closed pipe does, where the caller of the program has not chosen that
    /// it be ignored.
    void raise_pipe() const {
        ::signal(SIGPIPE, pipe_);
        ::raise(SIGPIPE);
    }

 private:
    void (*pipe_)(int);
};

ExitStatus run_command(const std::vector<nacre::cli::Command>& commands) {
    for (const nacre::cli::Command& command : commands) {
        if (!command.options->parsed()) continue;
        nacre::cli::check_values(*command.options);
        nacre::cli::check_files(command.files());
        return command.run();
    }
    return ExitStatus::usage;
}

/// The status of `work`, or of what it throws, which is printed.
template <class Work>
ExitStatus run(const Work& work) {
    try {
        return work();
    } catch (const nacre::cli::UsageError& error) {
        complain(error.what());
        return ExitStatus::usage;
    } catch (const nacre::SettingError& error) {  // options are called like the settings
        complain(std::string("--") + error.what());
        return ExitStatus::usage;
    } catch (const nacre::InputError& error) {
        complain(error.what());
        return ExitStatus::bad_input;
    } catch (const nacre::DomainError& error) {
        complain(error.what());
        return ExitStatus::bad_input;
    } catch (const std::bad_alloc&) {
        std::fputs("nacre: out of memory\n", stderr);  // needs none
        return ExitStatus::failure;
    } catch (const std::exception& error) {
        complain(error.what());
        return ExitStatus::failure;
    }
}

}  // namespace

int main(int argc, char** argv) {
    reserve_standard_streams();
    const SignalsAsErrors signals;
    CLI::App program{
        "Nacre predicts and renders the look of special-effect coatings from their composition.",
        "nacre"};
    program.set_version_flag("--version", std::string("nacre ") + nacre::version());
    program.require_subcommand(1);
    program.footer(
        "Exit status: 0 done, 1 wrong usage, 2 bad input, 3 failure while running, 4 a comparison "
        "failed or a standard was not matched.\n\"nacre COMMAND --help\" documents each command.");
    const std::vector<nacre::cli::Command> commands = {
        nacre::cli::add_studio(program),    nacre::cli::add_film(program),
        nacre::cli::add_solve(program),     nacre::cli::add_eval(program),
        nacre::cli::add_reference(program), nacre::cli::add_render(program),
        nacre::cli::add_merge(program),     nacre::cli::add_diff(program),
        nacre::cli::add_sparkle(program),   nacre::cli::add_study(program),
        nacre::cli::add_info(program),      nacre::cli::add_measure(program),
        nacre::cli::add_atlas(program),     nacre::cli::add_export(program),
        nacre::cli::add_panel(program),     nacre::cli::add_fit(program),
        nacre::cli::add_materials(program), nacre::cli::add_pigments(program),
        nacre::cli::add_pigment(program),   nacre::cli::add_scene(program),
        nacre::cli::add_completion(program)};
    ExitStatus status = run([&] {
        const auto ended =
            nacre::cli::parse_command_line(program, {argv + std::min(argc, 1), argv + argc});
        return ended ? *ended : run_command(commands);
    });
    if (std::ferror(stdout) != 0 && status == ExitStatus::ok) {
        signals.raise_pipe();
        complain("cannot write to standard output: its reader has gone");
        status = ExitStatus::failure;
    }
    return static_cast<int>(status);
}
