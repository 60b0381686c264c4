#include "clip/chart.h"
#include "clip/file.h"
#include "clip/frames.h"
#include "clip/helpers.h"
#include "clip/interrupt.h"
#include "clip/manifest.h"
#include "clip/process.h"
#include "clip/progress.h"
#include "clip/render_clip.h"
#include "commands/commands.h"
#include "commands/scene_options.h"
#include "compare/compared_scene.h"
#include "compare/comparison_chart.h"
#include "compare/comparison_painter.h"
#include "scene/words.h"
#include "study/method_error.h"
#include "study/plan.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>

namespace ropesim {
namespace {

constexpr const char* strip_layout = "strip";

struct CompareOptions {
    SceneOptions scene;
    Choice choice;
    std::string folder = "comparison";
    std::string layout = "overlay";
    std::string frames;
    int jobs = 1;
    bool overwrite = false;
    bool truth = false;
    bool quiet = false;
};

void add_options(CLI::App& app, CompareOptions& options) {
    add_scene_options(app, options.scene);
    // Here it may name several.
    app.remove_option(app.get_option("--steps"));
    app.add_option("--rope", options.choice.rope,
                   "the rope to move, by its name; the first where none is named")
        ->type_name("NAME");
    app.add_option("--methods", options.choice.methods,
                   "move it by these, such as symplectic_euler,stormer_verlet")
        ->type_name("M")
        ->delimiter(',');
    app.add_option("-s,--steps", options.choice.steps,
                   "steps per frame, one for all or one for each, such as 16,64")
        ->type_name("N")
        ->delimiter(',');
    app.add_option("-o,--output", options.folder,
                   "folder for frames, chart and numbers; made where it is missing")
        ->type_name("DIR")
        ->capture_default_str();
    app.add_option("--layout", options.layout, "overlay, side-by-side, difference or strip (one figure)")
        ->type_name("L")
        ->check(CLI::IsMember({"overlay", "side-by-side", "difference", strip_layout}).description(""))
        ->capture_default_str();
    app.add_option("--frames", options.frames, "only these frames, such as 0:60,90 (ends included)")
        ->type_name("LIST");
    app.add_option("--jobs", options.jobs, "processes that share the frames")
        ->type_name("N")
        ->check(CLI::Range(1, 1024).description(""))
        ->capture_default_str();
    app.add_flag("--overwrite", options.overwrite, "make frames anew that are there already");
    app.add_flag("--truth", options.truth, "measure how far each is from what the rope truly does");
    add_error_option(app, options.scene);
    app.add_flag("--quiet", options.quiet, "say nothing but errors");
    app.footer(
        "Without --methods and --steps the scene's own ropes are compared as they are.\n"
        "Examples:\n"
        "  ropesim compare                                   the assignment's Euler and Verlet\n"
        "  ropesim compare seed --methods stormer_verlet --steps 10,16,64 --truth\n"
        "  ropesim compare stiff-rope --layout side-by-side -o panels\n"
        "  ropesim compare --layout strip --frames 0,20,40,60,80,100");
}

Layout layout(const std::string& name) {
    return name == "overlay"      ? Layout::overlay
           : name == "difference" ? Layout::difference
                                  : Layout::side_by_side;
}

// Six frames from the first to the last, where none are asked for.
FrameList strip_frames(const CompareOptions& options, const Scene& scene) {
    if (!options.frames.empty()) return selected_frames(options.frames, scene);
    constexpr long count = 6;
    std::vector<long> frames;
    for (long i = 0; i < count; ++i) frames.push_back((scene.frames - 1) * i / (count - 1));
    return frames;
}

// Calls task(frame, positions) for the frames, in order.
template <class Task>
void for_each_frame(const Scene& scene, const FrameList& frames, Simulation& simulation, const Task& task) {
    for (const long frame : frames) {
        for (; simulation.frame() < frame; simulation.advance()) Interrupts::check();
        task(frame, simulation.positions());
    }
    for (; simulation.frame() < scene.frames - 1; simulation.advance()) Interrupts::check();
}

void write_strip(const CompareOptions& options, const Scene& scene, const Parting& parts,
                 Simulation& simulation) {
    constexpr std::size_t most = 30;
    const FrameList frames = strip_frames(options, scene);
    if (frames.size() > most)
        throw std::runtime_error("--frames: a strip of " + std::to_string(frames.size()) +
                                 " frames; expected " + std::to_string(most) + " at most");
    std::vector<long> numbers;
    std::vector<std::vector<Points>> positions;
    for_each_frame(scene, frames, simulation, [&](long frame, const std::vector<Points>& at) {
        numbers.push_back(frame);
        positions.push_back(at);
    });
    write_file(std::filesystem::path(options.folder) / "strip.png",
               encode_png(strip(scene, parts, numbers, positions), {}));
}

void write_frames(const CompareOptions& options, const Scene& scene, const Parting& parts,
                  Simulation& simulation) {
    const FrameList frames = selected_frames(options.frames, scene);
    const Interrupts interrupts;
    const std::filesystem::path folder = options.folder;
    std::unique_ptr<ComparisonPainter> painter;  // made after the helpers, each of which makes its own
    const auto draw = [&](long frame, const std::vector<Points>& positions) {
        if (!painter) painter = std::make_unique<ComparisonPainter>(scene, parts, layout(options.layout));
        write_file(folder / frame_name(frame, scene.frames), encode_png(painter->draw(frame, positions), {}));
    };
    const long count = static_cast<long>(frames.size());
    Helpers helpers(static_cast<int>(std::min<long>(options.jobs, count)) - 1, simulation.positions(), draw);
    Progress progress(count, "frames", !options.quiet);
    for_each_frame(scene, frames, simulation, [&](long frame, const std::vector<Points>& positions) {
        Interrupts::check();
        if (!helpers.take(frame, positions, helpers.count())) {
            draw(frame, positions);
            progress.done(1);
        }
        progress.done(helpers.drawn());
    });
    helpers.finish();
}

void write_chart(const CompareOptions& options, const Scene& scene, const Parting& parts) {
    const std::filesystem::path folder = options.folder;
    write_file(folder / "comparison.csv", to_csv(scene, parts));
    if (is_installed("gnuplot"))
        draw_chart(folder, "comparison", comparison_script(scene, parts));
    else if (!options.quiet)
        std::fprintf(stderr,
                     "ropesim: no chart: gnuplot is not installed; try: apt-get install gnuplot-nox\n");
}

// How far each run is from what its rope truly does, pixels. Of one rope by several methods that is what the
// scene asks for, also of a method of the other model.
std::vector<double> errors(const Scene& as_written, const Scene& compared, const Choice& choice) {
    const std::vector<Trajectory> motions = simulate(compared, runs(compared));
    std::vector<double> worst;
    for (std::size_t i = 0; i < compared.ropes.size(); ++i) {
        Problem asked = problem(compared, compared.ropes[i]);
        if (!choice.methods.empty() || !choice.steps.empty())
            asked.model = problem(as_written, rope_named(as_written, choice.rope)).model;
        worst.push_back(method_error(asked, truth(asked), motions[i].frames).worst);
    }
    return worst;
}

void say_what_is_true(const Scene& as_written, const Scene& compared, const Choice& choice) {
    const std::vector<double> worst = errors(as_written, compared, choice);
    for (std::size_t i = 0; i < worst.size(); ++i)
        std::printf("%s: %s\n", label(compared, compared.ropes[i]).c_str(),
                    std::isfinite(worst[i]) ? ("off by " + pixels(worst[i]) + " at worst").c_str()
                                            : "did not reach the end");
    const auto closest = std::ranges::min_element(worst);
    const auto other = std::ranges::max_element(worst);
    constexpr double as_far = 1.05;  // times, from where on one is called closer
    if (!std::isfinite(*closest)) return;
    if (*other <= as_far * *closest) {
        std::printf("all are as far from the truth\n");
        return;
    }
    const auto name = [&](auto run) {
        return compared.ropes[static_cast<std::size_t>(run - worst.begin())].name;
    };
    std::printf("closest to the truth: '%s'", name(closest).c_str());
    if (std::isfinite(*other))
        std::printf(", %.3g times closer than '%s'", *other / *closest, name(other).c_str());
    std::printf("\n");
}

int compare(const CompareOptions& options) {
    const Scene as_written = with_planned_ropes(open_scene(options.scene).scene);
    const Scene scene = compared_scene(as_written, options.choice);
    const bool as_strip = options.layout == strip_layout;
    ClipOptions clip;
    clip.folder = options.folder;
    clip.existing = options.overwrite ? Existing::overwrite : Existing::refuse;
    if (!as_strip) selected_frames(options.frames, scene);
    const FolderLock lock = prepare_folder(scene, clip);
    remove_manifest(options.folder);  // these are no frames that it could speak of
    Simulation simulation(
        scene, options.scene.no_error ? Simulation::Errors::left_out : Simulation::Errors::estimated);
    if (!options.quiet)
        for (const std::string& warning : stability_warnings(scene, simulation.runs()))
            std::fprintf(stderr, "ropesim: warning: %s\n", warning.c_str());
    const Parting parts = parting(scene);
    as_strip ? write_strip(options, scene, parts, simulation)
             : write_frames(options, scene, parts, simulation);
    write_chart(options, scene, parts);
    if (options.quiet) return 0;
    for (const std::string& line : summaries(scene, parts)) std::printf("%s\n", line.c_str());
    if (options.truth) say_what_is_true(as_written, scene, options.choice);
    if (const std::string line = error_line(simulation); !line.empty()) std::printf("%s\n", line.c_str());
    std::printf("%s, chart and numbers (comparison.csv) in %s\n", as_strip ? "strip.png" : "frames",
                one_line(options.folder).c_str());
    return 0;
}

}  // namespace

Command compare_command(CLI::App& app) {
    const auto options = std::make_shared<CompareOptions>();
    add_options(app, *options);
    return [options] { return compare(*options); };
}

}  // namespace ropesim
