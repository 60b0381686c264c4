// The command line, an argument a line, up to where a command would run: it is refused in plain text, or
// read.

#include "clip/frames.h"
#include "commands/commands.h"
#include "fuzz/target.h"
#include "scene/words.h"

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
void try_numbers(const std::string& argument) {
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
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const std::vector<std::string> arguments = lines({reinterpret_cast<const char*>(bytes), size});
    for (Command (*make)(CLI::App&) :
         {render_command, simulate_command, compare_command, plan_command, diff_command, scenes_command})
        try_command(make, arguments);
    for (const std::string& argument : arguments) try_numbers(argument);
    return 0;
}
