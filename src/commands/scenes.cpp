#include "commands/commands.h"
#include "scene/scene.h"
#include "scene/words.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace ropesim {
namespace {

int list() {
    for (const BuiltinScene& scene : builtin_scenes())
        std::printf("%-18s %s\n", std::string(scene.name).c_str(), std::string(scene.summary).c_str());
    return 0;
}

int print(const std::string& name) {
    std::vector<std::string_view> known;
    for (const BuiltinScene& scene : builtin_scenes()) {
        known.push_back(scene.name);
        if (scene.name != name) continue;
        std::fwrite(scene.toml.data(), 1, scene.toml.size(), stdout);
        return 0;
    }
    const std::string nearest = suggestion(name, known);
    throw std::runtime_error(
        "no built-in scene '" + printable(name) + "'" +
        (nearest.empty() ? "; 'ropesim scenes' lists them" : "; did you mean '" + nearest + "'?"));
}

}  // namespace

Command scenes_command(CLI::App& app) {
    const auto name = std::make_shared<std::string>();
    app.add_option("NAME", *name, "print this scene's file, to be saved and changed")->type_name("");
    app.footer(
        "Examples:\n"
        "  ropesim scenes\n"
        "  ropesim scenes bridge > my.toml");
    return [name] { return name->empty() ? list() : print(*name); };
}

}  // namespace ropesim
