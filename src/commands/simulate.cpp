#include "clip/file.h"
#include "clip/positions_writer.h"
#include "clip/simulation.h"
#include "commands/commands.h"
#include "commands/scene_options.h"
#include "study/plan.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>
#include <optional>

namespace ropesim {
namespace {

struct SimulateOptions {
    SceneOptions scene;
    std::string file = "positions.csv";
    std::string frames;
    std::vector<std::string> methods;
    std::string diagnostics;
    std::string truth;
    bool strict = false;
};

void add_options(CLI::App& app, SimulateOptions& options) {
    add_scene_options(app, options.scene);
    app.add_option("-o,--output", options.file,
                   "file for the positions, .csv or .npy; - is CSV to standard output")
        ->type_name("FILE")
        ->capture_default_str();
    app.add_option("--frames", options.frames, "only these frames, such as 2,4,10:20,90: (ends included)")
        ->type_name("LIST");
    app.add_option("--method", options.methods,
                   "method of every rope, or one for each; 'ropesim methods' lists them")
        ->type_name("M ...");
    app.add_option("--diagnostics", options.diagnostics,
                   "CSV of energies, largest stretch and tension, and length, per frame and rope")
        ->type_name("FILE");
    app.add_option("--truth", options.truth,
                   "positions of what the scene's ropes truly do; prints how far from it these are")
        ->type_name("FILE");
    add_error_option(app, options.scene);
    app.add_flag("--strict", options.strict, "exit with status 1 where a rope diverges");
    app.footer(
        "Examples:\n"
        "  ropesim simulate seed -o - --frames 119\n"
        "  ropesim simulate my.toml -s 256 --method stormer_verlet -o my.npy\n"
        "  ropesim render my.toml -s 256 --positions my.npy");
}

void set_methods(Scene& scene, const std::vector<std::string>& methods) {
    if (methods.empty()) return;
    if (methods.size() != 1 && methods.size() != scene.ropes.size())
        throw CLI::ValidationError("--method", "found " + std::to_string(methods.size()) +
                                                   ", expected one or " + std::to_string(scene.ropes.size()) +
                                                   " (one for each rope)");
    for (std::size_t i = 0; i < scene.ropes.size(); ++i)
        scene.ropes[i].method = methods.size() == 1 ? methods[0] : methods[i];
    check_scene(scene);
}

void check_file(const char* option, const std::string& file) {
    if (file != "-" && !file.ends_with(".npy") && !file.ends_with(".csv"))
        throw CLI::ValidationError(option, "'" + file + "' is neither .csv, .npy nor -");
}

// Writes the true positions, as far as they can be believed, and prints how far the simulated ones are from
// them, up to the last frame that is asked for.
void compare_with_truth(const std::string& file, Scene scene, const FrameList& frames) {
    scene.frames = static_cast<int>(frames.back()) + 1;
    const std::vector<Trajectory> trajectories = simulate(scene, runs(scene));
    std::vector<Trajectory> truths;
    for (std::size_t i = 0; i < scene.ropes.size(); ++i) {
        const Problem rope = problem(scene, scene.ropes[i]);
        Truth true_motion = truth(rope);
        const MethodError error = method_error(rope, true_motion, trajectories[i].frames);
        std::fprintf(stderr, "rope '%s' (%s): off by %.3g px at worst, %.3g px in frame %ld\n",
                     scene.ropes[i].name.c_str(), scene.ropes[i].method.c_str(), error.worst, error.last,
                     true_motion.frames - 1);
        Trajectory& believed = truths.emplace_back();
        believed.frames = std::move(true_motion.reference.frames);
        believed.frames.resize(static_cast<std::size_t>(true_motion.frames));
    }
    const auto writer = make_positions_writer(file, scene, frames);
    for (const auto& [frame, positions] : positions(truths, frames)) writer->add(frame, positions);
    writer->finish();
}

// Writes the files of the frames that are asked for; goes on to the last frame of the scene.
void write_frames(const SimulateOptions& options, const Scene& scene, const FrameList& frames,
                  Simulation& simulation) {
    const auto writer = make_positions_writer(options.file, scene, frames);
    std::optional<NewFile> diagnostics;
    if (!options.diagnostics.empty()) {
        diagnostics.emplace(options.diagnostics, Place::named);
        diagnostics->append(std::string(diagnostics_csv_header) + '\n');
    }
    for (;; simulation.advance()) {
        if (frames.contains(simulation.frame())) {
            writer->add(simulation.frame(), simulation.positions());
            if (diagnostics) diagnostics->append(diagnostics_csv_lines(simulation));
        }
        if (simulation.frame() == scene.frames - 1) break;
    }
    writer->finish();
    if (diagnostics) diagnostics->finish();
}

int simulate(const SimulateOptions& options) {
    check_file("-o", options.file);
    if (!options.truth.empty()) check_file("--truth", options.truth);
    Scene scene = open_scene(options.scene).scene;
    set_methods(scene, options.methods);
    scene = with_planned_ropes(scene);
    const FrameList frames = selected_frames(options.frames, scene);
    Simulation simulation(
        scene, options.scene.no_error ? Simulation::Errors::left_out : Simulation::Errors::estimated);
    for (const std::string& warning : stability_warnings(scene, simulation.runs()))
        std::fprintf(stderr, "ropesim: warning: %s\n", warning.c_str());
    write_frames(options, scene, frames, simulation);
    if (const std::string line = error_line(simulation); !line.empty())
        std::fprintf(stderr, "ropesim: %s\n", line.c_str());
    if (!options.truth.empty()) compare_with_truth(options.truth, scene, frames);
    bool diverged = false;
    for (std::size_t i = 0; i < simulation.runs().size(); ++i) {
        const auto frame = simulation.diverged(i);
        if (!frame) continue;
        std::fprintf(stderr, "ropesim: %s\n", divergence(scene, simulation.runs()[i], *frame).c_str());
        diverged = true;
    }
    return diverged && options.strict ? 1 : 0;
}

}  // namespace

Command simulate_command(CLI::App& app) {
    const auto options = std::make_shared<SimulateOptions>();
    add_options(app, *options);
    return [options] { return simulate(*options); };
}

}  // namespace ropesim
