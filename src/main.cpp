#include "clip/interrupt.h"
#include "clip/manifest.h"
#include "clip/want_of_memory.h"
#include "commands/commands.h"
#include "scene/words.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <vector>

namespace {

using ropesim::Command;

struct Row {
    const char* name;
    const char* summary;
    Command (*make)(CLI::App&);
};

constexpr std::array<Row, 12> rows{{
    {"render", "a scene in, numbered PNG frames out; the default", ropesim::render_command},
    {"simulate", "a scene in, positions of its masses out", ropesim::simulate_command},
    {"compare", "runs side by side: where methods part, and which is right", ropesim::compare_command},
    {"study", "charts accuracy against speed, and where methods fail", ropesim::study_command},
    {"plan", "find the cheapest method and step that keep to a tolerance", ropesim::plan_command},
    {"sweep", "a grid over keys of a scene: a row of results for each point", ropesim::sweep_command},
    {"submit", "a clip made by a cluster's nodes, through Slurm", ropesim::submit_command},
    {"diff", "compare pictures or folders of frames; status 3 where they differ", ropesim::diff_command},
    {"verify", "say whether a folder's clip is all there and whole; repair it", ropesim::verify_command},
    {"methods", "list the methods that move a rope", ropesim::methods_command},
    {"scenes", "list the built-in scenes, or print one", ropesim::scenes_command},
    {"doctor", "say what this program and this machine have", ropesim::doctor_command},
}};

constexpr int wrong_usage = 2;

int complain(const std::string& message) {
    std::fprintf(stderr, "ropesim: %s\n", ropesim::one_line(message).c_str());
    return 1;
}

const std::terminate_handler default_end = std::get_terminate();

[[noreturn]] void end_where_none_may_pass() {
    if (!ropesim::is_want_of_memory(std::current_exception())) default_end();
    complain(std::string(ropesim::want_of_memory));
    std::_Exit(1);
}

bool is_global_option(const std::string& argument) {
    return argument == "-h" || argument == "--help" || argument == "--version";
}

std::string unknown_command(const std::string& command) {
    std::vector<std::string_view> known;
    for (const Row& row : rows) known.push_back(row.name);
    const std::string nearest = ropesim::suggestion(command, known);
    return "no command '" + ropesim::printable(command) + "'; " +
           (nearest.empty() ? "to render a scene: ropesim render " + ropesim::printable(command)
                            : "did you mean '" + nearest + "'?");
}

// What CLI11 says in general, in the words of the command.
std::string explained(const CLI::ParseError& error, const CLI::App& command) {
    constexpr std::string_view no_conversion = "Could not convert: ";
    std::string words = error.what();
    if (words.starts_with(no_conversion))
        return words.substr(no_conversion.size()) + ": not what this option takes";
    if (words != "A subcommand is required") return words;
    std::string known;
    for (const CLI::App* each : command.get_subcommands({}))
        known += (known.empty() ? "" : ", ") + each->get_name();
    return command.get_name() + " what? expected one of " + known;
}

// CLI11 takes the arguments from the back.
std::vector<std::string> reversed_arguments(int count, char** values) {
    std::vector<std::string> arguments(values + 1, values + count);
    if (arguments.empty() || (arguments[0].starts_with('-') && !is_global_option(arguments[0])))
        arguments.insert(arguments.begin(), "render");
    return {arguments.rbegin(), arguments.rend()};
}

// An empty value is a script's variable that was not set, and not a wish for the default.
std::string problem_of_value(const std::string& value) {
    return value.empty() ? "is empty, expected a value" : "";
}

void refuse_empty_values(CLI::App& command) {
    for (CLI::Option* option : command.get_options())
        if (option->get_items_expected_max() > 0) option->check(problem_of_value);
}

void set_up(CLI::App& app) {
    app.name("ropesim");
    app.set_version_flag("--version", ropesim::version());
    app.set_help_flag("-h,--help", "say how it is used");
    app.require_subcommand(1);
    app.footer(
        "Without a command: as 'ropesim render'. Each command has a --help of its own.\n"
        "Example: ropesim render bridge -o bridge");
}

int interruptible(const CLI::App& app, const Command& command) {
    try {
        return command();
    } catch (const ropesim::Interrupted& interrupted) {
        const bool resumes = app.get_option_no_throw("--resume") != nullptr;
        complain(resumes ? "interrupted; the same command with --resume goes on from here" : "interrupted");
        return 128 + interrupted.signal;
    }
}

int run(int count, char** values) {
    CLI::App app("Simulates mass-spring ropes and renders them off screen into numbered PNG frames.");
    set_up(app);
    std::vector<Command> commands;
    for (const Row& row : rows) {
        CLI::App* command = app.add_subcommand(row.name, row.summary);
        command->set_help_flag("-h,--help", "say how it is used");
        commands.push_back(row.make(*command));
        refuse_empty_values(*command);
    }
    std::vector<std::string> arguments = reversed_arguments(count, values);
    const CLI::App* asked = &app;
    try {
        const auto row = std::find_if(rows.begin(), rows.end(),
                                      [&](const Row& each) { return arguments.back() == each.name; });
        if (row != rows.end())
            asked = app.get_subcommand(row->name);
        else if (!is_global_option(arguments.back()))
            throw CLI::ValidationError(unknown_command(arguments.back()));
        app.parse(arguments);
        return interruptible(*asked, commands[static_cast<std::size_t>(row - rows.begin())]);
    } catch (const CLI::Success& help_or_version) {
        return app.exit(help_or_version);
    } catch (const CLI::ParseError& error) {
        std::string command = asked == &app ? "" : ' ' + asked->get_name();
        for (const CLI::App* below : asked->get_subcommands()) command += ' ' + below->get_name();
        complain(explained(error, *asked) + " (see ropesim" + command + " --help)");
        return wrong_usage;
    }
}

}  // namespace

int main(int count, char** values) {
    ropesim::end_at_signals();
    std::set_terminate(end_where_none_may_pass);
    try {
        const int status = run(count, values);
        if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
            return complain("standard output: cannot write all of it");
        return status;
    } catch (const std::bad_alloc&) {
        return complain(std::string(ropesim::want_of_memory));
    } catch (const std::exception& error) {
        return complain(error.what());
    }
}
