#include "clip/manifest.h"
#include "clip/pace.h"
#include "clip/picture.h"
#include "clip/process.h"
#include "commands/commands.h"
#include "image/compact_png.h"
#include "image/png.h"
#include "render/lettering.h"
#include "simulation/instruction_set.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <string>

namespace ropesim {
namespace {

void line(const char* what, const std::string& found) {
    std::printf("%-16s %s\n", what, found.c_str());
}

std::string renderer() {
    try {
        return make_renderer(parse_scene(builtin_scenes().front().toml, "seed"))->description();
    } catch (const std::runtime_error& error) {
        return error.what();
    }
}

std::string libraries() {
    return "Eigen " + std::to_string(EIGEN_WORLD_VERSION) + "." + std::to_string(EIGEN_MAJOR_VERSION) + "." +
           std::to_string(EIGEN_MINOR_VERSION) + ", " + toml_library() + ", CLI11 " CLI11_VERSION ", " +
           png_library() + ", " + compact_library() + ", " + lettering_library();
}

// What the loops over masses use here, of what they are compiled for; positions are the same bits by each.
std::string instruction_set() {
#if defined(__x86_64__)
    const std::string architecture = "x86-64";
#elif defined(__aarch64__)
    const std::string architecture = "AArch64";
#else
    const std::string architecture = "this architecture";
#endif
    return architecture + ", " + std::string(name(widest_instruction_set()));
}

std::string presence(const char* program, const char* without) {
    return is_installed(program) ? "installed" : std::string("not installed; ") + without;
}

int report() {
    line("version", version());
    line("libraries", libraries());
    line("renderer", renderer());
    line("processors", std::to_string(processors()));
    line("instructions", instruction_set());
    line("ffmpeg", presence("ffmpeg", "--video needs it"));
    line("gnuplot", presence("gnuplot", "charts need it"));
    return 0;
}

}  // namespace

Command doctor_command(CLI::App& app) {
    app.footer("Example: ropesim doctor");
    return [] { return report(); };
}

}  // namespace ropesim
