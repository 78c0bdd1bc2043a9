#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <string>
#include <vector>

#include "apps/cli/model_options.h"
#include "apps/cli/options.h"
#include "nacre/nacre.h"
#include "nacre/render/builtin_scenes.h"

// Scripts by which shells complete commands, options, shipped paints and built-in scenes. They are
// made from the options that the program has, and are as old as the program that wrote them.

namespace nacre::cli {

namespace {

struct CompletionOptions : CommonOptions {
    std::string shell;
};

std::vector<const CLI::App*> commands_of(const CLI::App& program) {
    return program.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<std::string> long_options(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    return names;
}

/// Words beside the names of files: as the value of --paint and --versus, and after a command.
std::string words_for(const CLI::App& command) {
    if (command.get_name() == "render" || command.get_name() == "scene") {
        return fmt::format("{}", fmt::join(render::builtin_scene_names(), " "));
    }
    return fmt::format("{}", fmt::join(shipped_paints(), " "));
}

std::string bash_script(const CLI::App& program) {
    std::string names, cases;
    for (const CLI::App* command : commands_of(program)) {
        names += (names.empty() ? "" : " ") + command->get_name();
        cases += fmt::format(
            "        {})\n            options=\"{}\"\n            words=\"{}\" ;;\n",
            command->get_name(), fmt::join(long_options(*command), " "), words_for(*command));
    }
    return fmt::format(R"(# Completion of nacre for bash: source this file.
_nacre() {{
    local current=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} options= words=
    if ((COMP_CWORD == 1)); then
        COMPREPLY=($(compgen -W "{} help --help --version" -- "$current"))
        return
    fi
    case ${{COMP_WORDS[1]}} in
        help) COMPREPLY=($(compgen -W "{}" -- "$current")); return ;;
{}    esac
    case $before in
        --paint | --versus | --start) words="{}" ;;
        --model) words="{}" ;;
    esac
    if [[ $current == -* ]]; then
        COMPREPLY=($(compgen -W "$options" -- "$current"))
    else
        COMPREPLY=($(compgen -W "$words" -- "$current") $(compgen -f -- "$current"))
    fi
}}
complete -o filenames -F _nacre nacre
)",
                       names, names, cases, fmt::join(shipped_paints(), " "),
                       fmt::join(models_that([](const bsdf::ModelInfo&) { return true; }), " "));
}

std::string zsh_script(const CLI::App& program) {
    return "# Completion of nacre for zsh: source this file. By bash's, which zsh understands.\n"
           "autoload -U +X compinit && compinit\nautoload -U +X bashcompinit && bashcompinit\n" +
           bash_script(program);
}

/// In single quotes of fish.
std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text) {
        if (c == '\'' || c == '\\') result += '\\';
        result += c;
    }
    return result + "'";
}

std::string fish_script(const CLI::App& program) {
    std::string script = "# Completion of nacre for fish: source this file.\n";
    for (const CLI::App* command : commands_of(program)) {
        const std::string name = command->get_name();
        script += fmt::format("complete -c nacre -n __fish_use_subcommand -a {} -d {}\n", name,
                              quoted(command->get_description()));
        const std::string here =
            fmt::format("complete -c nacre -n '__fish_seen_subcommand_from {}'", name);
        script += fmt::format("{} -a {}\n", here, quoted(words_for(*command)));
        for (const CLI::Option* option : command->get_options()) {
            for (const std::string& long_name : option->get_lnames()) {
                script += fmt::format("{} -l {}{} -d {}\n", here, long_name,
                                      option->get_items_expected_max() > 0 ? " -r" : "",
                                      quoted(option->get_description()));
            }
        }
    }
    return script;
}

std::string script_for(const std::string& shell, const CLI::App& program) {
    if (shell == "bash") return bash_script(program);
    return shell == "zsh" ? zsh_script(program) : fish_script(program);
}

}  // namespace

Command add_completion(CLI::App& program) {
    auto options = std::make_shared<CompletionOptions>();
    CLI::App* completion =
        program.add_subcommand("completion", "Write a script by which your shell completes nacre");
    completion->add_option("SHELL", options->shell, "bash, zsh or fish")
        ->required()
        ->check(CLI::IsMember({"bash", "zsh", "fish"}));
    add_output(*completion, *options);
    completion->footer(
        "Example, for bash:\n"
        "  nacre completion bash > ~/.local/share/bash-completion/completions/nacre");
    return {completion, [options] { return files_of(*options, {}); },
            [options, &program] {
                emit(*options, script_for(options->shell, program));
                return ExitStatus::ok;
            }};
}

}  // namespace nacre::cli
