#include "clip/chart.h"
#include "clip/file.h"
#include "clip/folder_lock.h"
#include "clip/interrupt.h"
#include "clip/manifest.h"
#include "commands/commands.h"
#include "commands/failure_sheet.h"
#include "commands/scene_options.h"
#include "image/png.h"
#include "scene/words.h"
#include "study/failures.h"
#include "study/stability.h"
#include "study/work_precision.h"
#include "study/work_precision_chart.h"
#include "study/work_precision_csv.h"

#include <unistd.h>
#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdio>
#include <memory>
#include <stdexcept>
#include <utility>

namespace ropesim {
namespace {

struct StudyOptions {
    SceneOptions scene;
    std::string rope;
    std::string folder = "study";
    std::optional<int> frames;
    std::vector<std::string> methods;
    std::string against = "stiffness";
};

void add_options(CLI::App& app, StudyOptions& options) {
    add_scene_options(app, options.scene);
    app.add_option("--rope", options.rope, "the rope to study, by its name; the first where none is named")
        ->type_name("NAME");
    app.add_option("-o,--output", options.folder, "folder for charts and numbers; made where it is missing")
        ->type_name("DIR")
        ->capture_default_str();
    app.add_option("--frames", options.frames, "frames of the clip, instead of the scene's")->type_name("N");
    app.add_option("--methods", options.methods, "only these, such as stormer_verlet,odeint:velocity_verlet")
        ->type_name("M")
        ->delimiter(',');
}

Scene opened(const StudyOptions& options) {
    Scene scene = open_scene(options.scene).scene;
    if (options.frames) scene.frames = *options.frames;
    check_scene(scene);
    if (scene.frames < 2) throw std::runtime_error("a study needs a motion: expected 2 frames or more");
    return scene;
}

// Others are kept out while the lock lives.
[[nodiscard]] FolderLock made_folder(const std::string& folder) {
    make_folder(folder);
    return {folder, ""};
}

// One line on a terminal that says what is being done and how far it is; no line elsewhere.
class StatusLine {
  public:
    ~StatusLine() {
        if (shown_) std::fputs("\r\x1b[K", stderr);
    }
    void show(std::string_view doing, long done, long all) {
        Interrupts::check();
        const auto now = std::chrono::steady_clock::now();
        if (!terminal_ || (shown_ && now - last_ < std::chrono::milliseconds(100))) return;
        last_ = now;
        shown_ = true;
        std::fprintf(stderr, "\r%.*s", static_cast<int>(doing.size()), doing.data());
        if (all > 0) std::fprintf(stderr, ", %ld of %ld", done, all);
        std::fputs("\x1b[K", stderr);
        std::fflush(stderr);
    }

  private:
    bool terminal_ = ::isatty(STDERR_FILENO) == 1;
    bool shown_ = false;
    std::chrono::steady_clock::time_point last_;
};

// "scene seed, rope 'Euler': 16 masses, elastic, 120 frames"
std::string subject(const StudyOptions& options, const Scene& scene, const SceneRope& rope,
                    const Problem& problem) {
    return "scene " + one_line(std::filesystem::path(options.scene.scene).filename().string()) + ", rope '" +
           rope.name + "': " + std::to_string(rope.nodes) + " masses, " + std::string(name(problem.model)) +
           ", " + std::to_string(scene.frames) + " frames";
}

void say_cheapest(const WorkPrecision& study) {
    bool is_first = true;
    for (const double pixels : {10.0, 1.0, 0.5, 0.1, 1e-2, 1e-3, 1e-4, 1e-6, 1e-8}) {
        const Cheapest own = cheapest(study, true, pixels);
        const Cheapest other = cheapest(study, false, pixels);
        if (!own.measurement) continue;
        if (std::exchange(is_first, false))
            std::printf("%9s  %-22s %10s %11s   %s\n", "error, px", "cheapest method", "steps", "time",
                        "of others");
        std::printf("%9g  %-22s %10g %8.2f us", pixels, label(own.curve->contender).c_str(),
                    own.measurement->setting, 1e6 * own.measurement->time.median);
        if (other.measurement)
            std::printf("   %.2f times as fast as %s",
                        other.measurement->time.median / own.measurement->time.median,
                        label(other.curve->contender).c_str());
        std::printf("\n");
    }
}

std::vector<const Method*> methods_named(const Problem& problem, const std::vector<std::string>& names) {
    std::vector<const Method*> result;
    for (const std::string& name : names) {
        result.push_back(&find_method(name));
        const std::string why_not = obstacle(problem, result.back()->model);
        if (!why_not.empty()) throw std::runtime_error(name + " " + why_not);
    }
    if (names.empty())
        for (const Method& method : methods())
            if (fits(problem, method)) result.push_back(&method);
    return result;
}

int stability(const StudyOptions& options) {
    const Scene scene = opened(options);
    const SceneRope& rope = rope_named(scene, options.rope);
    const Problem subject_problem = problem(scene, rope);
    const std::vector<const Method*> all = methods_named(subject_problem, options.methods);
    require_gnuplot();
    const FolderLock lock = made_folder(options.folder);
    const Against against = options.against == "damping" ? Against::damping : Against::stiffness;
    StatusLine status;
    const StabilityMap map = stability_map(
        subject_problem, against, all, [&](long done, long of) { status.show("stability, runs", done, of); });
    const Truth its_truth = truth(subject_problem);
    const std::vector<Failure> failing = failures(subject_problem, its_truth, all, [&](long done, long of) {
        status.show("where each method fails", done, of);
    });
    const std::string about = subject(options, scene, rope, subject_problem);
    const std::filesystem::path folder = options.folder;
    write_file(folder / "failures.png", encode_png(failure_sheet(scene, rope, its_truth, failing), {}));
    write_file(folder / "stability.csv", to_csv(map, version() + "; " + about));
    draw_chart(folder, "stability", stability_script(map, "Stability, " + about));
    std::printf("chart stability.png (and .svg), numbers stability.csv, pictures failures.png in %s\n",
                one_line(options.folder).c_str());
    return 0;
}

int work_precision(const StudyOptions& options) {
    const Scene scene = opened(options);
    const SceneRope& rope = rope_named(scene, options.rope);
    const Problem subject_problem = problem(scene, rope);
    const std::vector<Contender> all = contenders(subject_problem, options.methods);
    require_gnuplot();
    const FolderLock lock = made_folder(options.folder);
    StatusLine status;
    const WorkPrecision study =
        work_precision(subject_problem, all,
                       [&](std::string_view doing, long done, long of) { status.show(doing, done, of); });
    const std::string about = subject(options, scene, rope, subject_problem);
    const std::filesystem::path folder = options.folder;
    write_file(folder / "work_precision.csv", to_csv(study, version() + ", " + machine() + "; " + about));
    draw_chart(folder, "work_precision",
               work_precision_script(study, Work::time, "work_precision", "Work-precision, " + about));
    draw_chart(folder, "work_count",
               work_precision_script(study, Work::count, "work_count", "Work-precision, " + about));
    say_cheapest(study);
    std::printf("charts work_precision.png, work_count.png (and .svg), numbers work_precision.csv in %s\n",
                one_line(options.folder).c_str());
    return 0;
}

}  // namespace

Command study_command(CLI::App& app) {
    const auto options = std::make_shared<StudyOptions>();
    app.require_subcommand(1);
    app.footer("Example: ropesim study work-precision bridge -o bridge-study");
    CLI::App* chart = app.add_subcommand(
        "work-precision", "every method's error, in pixels, against what it costs: CSV and charts");
    add_options(*chart, *options);
    chart->footer(
        "Examples:\n"
        "  ropesim study work-precision\n"
        "  ropesim study work-precision my.toml --frames 60 --methods stormer_verlet,blanes_moan_6 -o chart");
    CLI::App* map = app.add_subcommand(
        "stability", "where methods hold and fail, over steps and stiffness: CSV, a map, and pictures");
    add_options(*map, *options);
    map->add_option("--against", options->against, "what varies beside the steps: stiffness or damping")
        ->type_name("WHAT")
        ->check(CLI::IsMember({"stiffness", "damping"}).description(""))
        ->capture_default_str();
    map->footer(
        "Examples:\n"
        "  ropesim study stability --frames 60\n"
        "  ropesim study stability my.toml --against damping --methods symplectic_euler,xpbd");
    for (CLI::App* each : {chart, map}) each->set_help_flag("-h,--help", "say how it is used");
    return [options, map] { return map->parsed() ? stability(*options) : work_precision(*options); };
}

}  // namespace ropesim
