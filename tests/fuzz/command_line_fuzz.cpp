// The command line, an argument a line, up to where a command would run: it is refused in plain text, or
// read.

#include "clip/frames.h"
#include "commands/commands.h"
#include "fuzz/target.h"
#include "scene/words.h"
#include "sweep/sweep.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

using namespace ropesim;

namespace {

std::vector<std::string> lines(std::string_view text) {
    std::vector<std::string> result;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        result.emplace_back(text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return result;
}

void try_command(Command (*make)(CLI::App&), std::vector<std::string> arguments) {
    CLI::App app("fuzz");
    const Command command = make(app);  // keeps what the options are read into
    std::ranges::reverse(arguments);
    try {
        app.parse(arguments);
    } catch (const CLI::Success&) {
    } catch (const CLI::ParseError& error) {
        require_plain(one_line(error.what()));  // as main says it
    }
}

// What commands read out of an option's text.
void try_values(const std::string& argument) {
    static const Scene seed = parse_scene(builtin_scenes().front().toml, "seed");
    try {
        if (parse_frames(argument, 100).back() >= 100) break_off("a frame past the end");
    } catch (const std::runtime_error& error) {
        require_plain(error.what());
    }
    try {
        const Shard shard = parse_shard(argument);
        if (shard.index < 0 || shard.index >= shard.count) break_off("no such shard");
    } catch (const std::runtime_error& error) {
        require_plain(error.what());
    }
    try {
        if (make_sweep(seed, {argument}).points() < 1) break_off("a sweep of no points");
    } catch (const std::runtime_error& error) {
        require_plain(error.what());
    }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const std::vector<std::string> arguments = lines({reinterpret_cast<const char*>(bytes), size});
    for (Command (*make)(CLI::App&) :
         {render_command, simulate_command, compare_command, study_command, plan_command, sweep_command,
          submit_command, diff_command, verify_command, scenes_command})
        try_command(make, arguments);
    for (const std::string& argument : arguments) try_values(argument);
    return 0;
}
