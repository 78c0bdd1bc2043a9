#include <fmt/format.h>
#include <fmt/ranges.h>
#include <spawn.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <memory>
#include <string>
#include <vector>

#include "apps/cli/options.h"
#include "apps/cli/paint_options.h"
#include "apps/studio/messages/messages.h"
#include "apps/studio/server.h"
#include "nacre/core/parallel.h"
#include "nacre/io/recipe_text.h"
#include "nacre/models/models.h"
#include "nacre/nacre.h"

extern char** environ;

namespace nacre::cli {

namespace {

struct StudioOptions : CommonOptions {
    std::string recipe;
    unsigned short port = 0;
    std::string listen = "127.0.0.1", model = std::string(models::names_of_fitted().front());
    bool open_to_network = false, no_open = false;
};

/// Shows the page in the user's browser, where there is a display.
void open_browser(const std::string& url) {
    if (!std::getenv("DISPLAY") && !std::getenv("WAYLAND_DISPLAY")) return;
    const char* const arguments[] = {"xdg-open", url.c_str(), nullptr};
    pid_t child = 0;
    // Without it the address that was printed will do.
    (void)::posix_spawnp(&child, arguments[0], nullptr, nullptr,
                         const_cast<char* const*>(arguments), environ);
}

/// The text of the recipe, with what it names in files written out.
std::string text_of(const StudioOptions& options) {
    const Paint paint = open_input(options, options.recipe);
    if (paint.kind() != Kind::recipe) {
        throw InputError(options.recipe + ": holds no recipe (TOML), which the studio needs");
    }
    return paint.recipe_text(References()).text;
}

ExitStatus run(const StudioOptions& options) {
    if (!studio::is_loopback(options.listen) && !options.open_to_network) {
        throw UsageError(fmt::format(
            "--listen = {}: other machines could use this one, and whoever reads the address on "
            "the way knows the token in it; if that is meant, give --open-to-the-network too",
            options.listen));
    }
    studio::ServerSettings settings{
        .address = options.listen, .port = options.port, .prepare = true};
    try {
        settings.reading_model =
            studio::parse_reading_model(options.model, models::names_of_fitted());
    } catch (const InputError& error) {
        throw UsageError(fmt::format("--model = {}: {}", options.model, error.what()));
    }
    if (!options.recipe.empty()) settings.toml = text_of(options);
    const ThreadLimit threads(options.threads);
    studio::Server server(settings);
    print_data(server.url() + "\n");
    say(options, "The studio is open; Ctrl-C ends it.");
    if (!options.no_open) open_browser(server.url());
    server.run(true);
    return ExitStatus::ok;
}

}  // namespace

Command add_studio(CLI::App& program) {
    auto options = std::make_shared<StudioOptions>();
    CLI::App* command = program.add_subcommand(
        "studio", "Design a paint in the browser: sliders, angles, pictures, fits");
    command->add_option("RECIPE", options->recipe, "Recipe (TOML) or shipped paint to start with");
    command
        ->add_option(
            "--model", options->model,
            fmt::format("Model by which paints are read at first, which the page can change: {}",
                        fmt::join(models::names_of_fitted(), ", ")))
        ->capture_default_str();
    command->add_option("--port", options->port, "Port to listen at; 0 is any that is free")
        ->capture_default_str();
    command->add_flag("--no-open", options->no_open, "Only print the address, open no browser");
    command->add_option("--listen", options->listen, "Address of this machine to listen at")
        ->type_name("ADDRESS")
        ->capture_default_str();
    command->add_flag("--open-to-the-network", options->open_to_network,
                      "Let --listen be an address that other machines reach");
    add_threads(*command, *options);
    add_quiet(*command, *options);
    add_input_options(*command, *options);
    command->footer(
        "Prints the address of the page, which holds a token: who knows it may use the server. It\n"
        "listens on this machine alone, serves no files of it, and runs until Ctrl-C. Recipes "
        "from\n"
        "the page name no files; what RECIPE names is read once, at the start.\n"
        "docs/studio-api.md says how other programs use the server.\n\n"
        "Example:\n"
        "  nacre studio paints/red-gold.toml");
    return {command, [options] { return files_of(*options, {options->recipe}); },
            [options] { return run(*options); }};
}

}  // namespace nacre::cli
