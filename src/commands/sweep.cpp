#include "clip/chart.h"
#include "clip/contact_sheet.h"
#include "clip/digest.h"
#include "clip/file.h"
#include "clip/helpers.h"
#include "clip/interrupt.h"
#include "clip/manifest.h"
#include "clip/process.h"
#include "clip/progress.h"
#include "clip/render_clip.h"
#include "commands/batch_options.h"
#include "commands/commands.h"
#include "commands/scene_options.h"
#include "image/png.h"
#include "scene/words.h"
#include "study/plan.h"
#include "sweep/point_cell.h"
#include "sweep/sweep_chart.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <stdexcept>

namespace ropesim {
namespace {

struct SweepOptions {
    SceneOptions scene;
    std::vector<std::string> variations;
    std::filesystem::path folder = "sweep";
    bool clips = false;
    std::string frames;
    std::optional<long> sheet_frame;
    int jobs = 1;
    std::string shard = "0/1";
    bool resume = false;
    bool overwrite = false;
    bool quiet = false;
    bool submit = false;
    BatchOptions batch;
};

void add_options(CLI::App& app, SweepOptions& options) {
    add_scene_options(app, options.scene);
    app.add_option("--vary", options.variations,
                   "keys of the scene and their values: KEY=A:B:N (N values from A to B), KEY=A:B:N:log, or "
                   "KEY=V1,V2,...; of one rope: rope[0].KEY or rope[NAME].KEY")
        ->type_name("KEY=VALUES ...")
        ->required();
    app.add_option("-o,--output", options.folder, "folder for numbers and pictures; made where it is missing")
        ->type_name("DIR")
        ->capture_default_str();
    app.add_flag("--clips", options.clips, "a clip of each point, too, and a contact sheet of them");
    app.add_option("--frames", options.frames, "only these frames of the clips, such as 0:60,90")
        ->type_name("LIST");
    app.add_option("--sheet-frame", options.sheet_frame, "frame on the contact sheet; the last by default")
        ->type_name("N");
    app.add_option("--jobs", options.jobs, "processes that share the points")
        ->type_name("N")
        ->check(CLI::Range(1, 1024).description(""))
        ->capture_default_str();
    app.add_option("--shard", options.shard,
                   "only points whose number is I modulo N; without it, --resume gathers all shards")
        ->type_name("I/N");
    CLI::Option* resume =
        app.add_flag("--resume", options.resume, "keep what this very sweep and version made");
    app.add_flag("--overwrite", options.overwrite, "make all points anew")->excludes(resume);
    add_error_option(app, options.scene);
    app.add_flag("--quiet", options.quiet, "say nothing but errors");
    CLI::Option* submit = app.add_flag("--submit", options.submit,
                                       "let a cluster's nodes do it, through Slurm: --shards N tasks");
    submit->excludes("--shard");
    add_batch_options(app, options.batch);
    for (const char* option : {"--shards", "--partition", "--time", "--dry-run"})
        app.get_option(option)->needs(submit);
    app.footer(
        "Numbers of each point in sweep.csv: error in the worst frame, work, largest stretch, energy drift, "
        "where it\ndiverged; a chart where one or two keys are varied.\n"
        "Examples:\n"
        "  ropesim sweep --vary steps_per_frame=4:256:13:log\n"
        "  ropesim sweep bridge --vary method=stormer_verlet,xpbd stiffness=10:100000:9:log --jobs 2\n"
        "  ropesim sweep my.toml --vary damping=0:0.2:5 'rope[0].nodes=8,16,32' --clips -o grid\n"
        "  ropesim sweep my.toml --vary stiffness=10:100000:60:log -o /shared/grid --submit --shards 10");
}

// A sweep, and what is made of each of its points.
class PointWorker {
  public:
    PointWorker(const SweepOptions& options, Sweep sweep) : options_(options), sweep_(std::move(sweep)) {
        std::string text = version() + '\n' + to_toml(sweep_.scene) + '\n' + options.frames + '\n';
        text += options.clips ? "clips " + std::to_string(options.sheet_frame.value_or(-1)) : "numbers";
        if (options.scene.no_error) text += " without errors";
        for (const std::string& each : options.variations) text += '\n' + each;
        digest_ = ropesim::digest(text);
    }

    const Sweep& sweep() const { return sweep_; }
    const std::string& digest() const { return digest_; }  // of all that says what the points make

    // With this extension: ".csv", its line; ".png", its picture for the contact sheet; "", its clip's
    // folder.
    std::filesystem::path path(long point, const char* extension) const {
        return options_.folder / (point_name(sweep_, point) + extension);
    }

    // What was found out about a point, by this very sweep; none where nothing was.
    std::optional<PointResult> result(long point) const {
        const std::filesystem::path file = path(point, ".csv");
        std::error_code ignored;
        if (!std::filesystem::is_regular_file(file, ignored)) return std::nullopt;
        const auto bytes = read_regular_file(file);
        const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        if (!text.starts_with(digest_ + '\n')) return std::nullopt;
        return parse_csv_line(sweep_, point, text.substr(digest_.size() + 1));
    }

    // Runs a point and leaves its files, its line last.
    void work(long point) const {
        Scene scene = sweep_.at(point);
        PointResult result;
        std::vector<Points> positions;
        try {
            check_scene(scene);
            scene = with_planned_ropes(scene);
        } catch (const std::runtime_error& error) {
            result.failure = error.what();
        }
        if (result.failure.empty()) result = run(point, scene, positions);
        if (options_.clips)
            write_file(path(point, ".png"),
                       encode_png(point_cell(sweep_, point, scene, positions, result), {}));
        write_file(path(point, ".csv"), digest_ + '\n' + csv_line(sweep_, point, result));
    }

  private:
    // Leaves the positions for the contact sheet.
    PointResult run(long point, const Scene& scene, std::vector<Points>& positions) const {
        Simulation simulation(
            scene, options_.scene.no_error ? Simulation::Errors::left_out : Simulation::Errors::always);
        if (options_.clips) render(point, scene, simulation);
        while (simulation.frame() < scene.frames - 1) {
            Interrupts::check();
            simulation.advance();
        }
        positions = simulation.positions();
        if (options_.clips && options_.sheet_frame) {
            Simulation again(scene, Simulation::Errors::left_out);
            while (again.frame() < std::min<long>(*options_.sheet_frame, scene.frames - 1)) again.advance();
            positions = again.positions();
        }
        return point_result(simulation);
    }

    void render(long point, const Scene& scene, Simulation& simulation) const {
        ClipOptions clip;
        clip.folder = path(point, "");
        clip.frames = parse_frames(options_.frames, scene.frames);
        clip.jobs = 1;
        clip.existing = options_.overwrite ? Existing::overwrite : Existing::resume;
        const FolderLock lock = prepare_folder(scene, clip);
        render_clip(scene, simulation, nullptr, clip);
    }

    const SweepOptions& options_;
    Sweep sweep_;
    std::string digest_;
};

constexpr const char* csv_name = "sweep.csv";

Sweep open_sweep(const SweepOptions& options) {
    const Scene scene = open_scene(options.scene).scene;
    selected_frames(options.frames, scene);
    if (options.sheet_frame && (*options.sheet_frame < 0 || *options.sheet_frame >= scene.frames))
        throw CLI::ValidationError("--sheet-frame", "found " + std::to_string(*options.sheet_frame) +
                                                        ", expected 0 to " +
                                                        std::to_string(scene.frames - 1));
    if (!options.clips && (options.sheet_frame || !options.frames.empty()))
        throw CLI::ValidationError(options.sheet_frame ? "--sheet-frame" : "--frames",
                                   "is for clips, which --clips asks for");
    try {
        return make_sweep(scene, options.variations);
    } catch (const std::runtime_error& error) {
        throw CLI::ValidationError("--vary", error.what());
    }
}

// Keeps others out of the folder for as long as the lock is kept, but for shards of the same sweep.
[[nodiscard]] FolderLock prepare(const SweepOptions& options, const PointWorker& worker, const Shard& shard) {
    make_folder(options.folder);
    FolderLock lock(options.folder, shard.count == 1 ? "" : worker.digest());
    remove_stale_temporaries(options.folder);
    bool there = std::filesystem::exists(options.folder / csv_name);
    for (long point = 0; point < worker.sweep().points() && !options.resume; ++point) {
        if (!shard.contains(point)) continue;
        there = there || std::filesystem::exists(worker.path(point, ".csv")) ||
                std::filesystem::exists(worker.path(point, ""));
        if (options.overwrite) std::filesystem::remove(worker.path(point, ".csv"));
    }
    if (there && !options.resume && !options.overwrite)
        throw std::runtime_error(
            options.folder.string() +
            " already holds a sweep; --resume keeps what this one made, --overwrite makes "
            "it anew, -o names another folder");
    std::error_code error;
    std::filesystem::remove(options.folder / csv_name, error);  // until the points are what it says
    if (error) throw std::runtime_error(options.folder.string() + ": cannot write: " + error.message());
    return lock;
}

// Runs the points of the shard that have not been run.
void run_points(const SweepOptions& options, const PointWorker& worker, const Shard& shard) {
    std::vector<long> left;
    for (long point = 0; point < worker.sweep().points(); ++point)
        if (shard.contains(point) && !worker.result(point)) left.push_back(point);
    const Interrupts interrupts;
    const auto work = [&](long point) { worker.work(point); };
    const auto jobs = std::min<long>(options.jobs, std::max<long>(1, static_cast<long>(left.size())));
    Helpers helpers(static_cast<int>(jobs) - 1, /*positions=*/{},
                    [&](long point, const auto&) { work(point); });
    Progress progress(static_cast<long>(left.size()), "points", !options.quiet);
    for (const long point : left) {
        Interrupts::check();
        if (!helpers.take(point, {}, helpers.count())) {
            work(point);
            progress.done(1);
        }
        progress.done(helpers.drawn());
    }
    helpers.finish();
}

std::string write_chart(const SweepOptions& options, const Sweep& sweep,
                        const std::vector<PointResult>& results) {
    if (!has_chart(sweep)) return "";
    if (is_installed("gnuplot")) {
        draw_chart(options.folder, "sweep", sweep_script(sweep, results));
        return ", sweep.png (and .svg)";
    }
    if (!options.quiet)
        std::fprintf(stderr,
                     "ropesim: no chart: gnuplot is not installed; try: apt-get install gnuplot-nox\n");
    return "";
}

std::string write_sheet(const SweepOptions& options, const PointWorker& worker) {
    const Sweep& sweep = worker.sweep();
    if (!options.clips) return "";
    if (sweep.points() > most_cells) {
        if (!options.quiet)
            std::fprintf(stderr, "ropesim: no contact sheet: it has room for %ld points\n", most_cells);
        return "";
    }
    std::vector<Image> cells;
    for (long point = 0; point < sweep.points(); ++point)
        cells.push_back(
            decode_png(read_regular_file(worker.path(point, ".png")), worker.path(point, ".png").string()));
    write_file(options.folder / "sheet.png",
               encode_png(contact_sheet(cells, sheet_columns(sweep), sweep.scene.background), {}));
    return ", sheet.png";
}

// Makes one table and its pictures of what the points left.
void gather(const SweepOptions& options, const PointWorker& worker) {
    const Sweep& sweep = worker.sweep();
    std::vector<PointResult> results;
    std::string csv = sweep_csv_header(sweep);
    for (long point = 0; point < sweep.points(); ++point) {
        const auto result = worker.result(point);
        if (!result)
            throw std::runtime_error(worker.path(point, ".csv").string() + ": was changed meanwhile");
        csv += csv_line(sweep, point, *result);
        results.push_back(*result);
    }
    write_file(options.folder / csv_name, csv);
    const std::string chart = write_chart(options, sweep, results);
    const std::string sheet = write_sheet(options, worker);
    for (long point = 0; point < sweep.points(); ++point)
        for (const char* extension : {".csv", ".png"}) std::filesystem::remove(worker.path(point, extension));
    if (options.quiet) return;
    const auto failed =
        std::ranges::count_if(results, [](const auto& each) { return !each.failure.empty(); });
    const auto diverged =
        std::ranges::count_if(results, [](const auto& each) { return each.diverged.has_value(); });
    std::printf("%zu points, %td diverged, %td failed: sweep.csv%s%s in %s\n", results.size(), diverged,
                failed, chart.c_str(), sheet.c_str(), one_line(options.folder.string()).c_str());
}

// The options that say what each point makes.
std::string point_options(const SweepOptions& options) {
    std::string text = " --vary";
    for (const std::string& each : options.variations) text += ' ' + shell_word(each);
    if (options.clips) text += " --clips";
    if (!options.frames.empty()) text += " --frames " + shell_word(options.frames);
    if (options.sheet_frame) text += " --sheet-frame " + std::to_string(*options.sheet_frame);
    if (options.scene.no_error) text += " --no-error";
    return text;
}

int submit_sweep(const SweepOptions& options, const PointWorker& worker) {
    const std::filesystem::path folder = std::filesystem::absolute(options.folder).lexically_normal();
    const std::filesystem::path batch = folder / "batch";
    const std::string run = this_program() + " sweep " + shell_word((batch / "scene.toml").string()) +
                            point_options(options) + " -o " + shell_word(folder.string()) + " --resume";
    const std::string shards = std::to_string(options.batch.request.shards);
    const std::vector<BatchJob> jobs{
        {"points",
         "Task I of " + shards + " does the points whose number is I modulo " + shards + ".",
         true,
         {"exec " + run + " --quiet --shard \"$SLURM_ARRAY_TASK_ID/" + shards + '"'}},
        {"gather",
         "Does what failed tasks left; makes one table and its pictures of all points.",
         false,
         {"exec " + run + " --jobs " + std::to_string(options.jobs)}}};
    if (!options.batch.dry_run) {
        require_sbatch("the same without --submit, with --jobs 2");
        const FolderLock lock = prepare(options, worker, {});
    }
    hand_over(options.batch, jobs, batch, to_toml(worker.sweep().scene));
    return 0;
}

int sweep(const SweepOptions& options) {
    const PointWorker worker(options, open_sweep(options));
    if (options.submit) return submit_sweep(options, worker);
    const Shard shard = selected_shard(options.shard);
    const FolderLock lock = prepare(options, worker, shard);
    run_points(options, worker, shard);
    if (shard.count == 1) gather(options, worker);
    return 0;
}

}  // namespace

Command sweep_command(CLI::App& app) {
    const auto options = std::make_shared<SweepOptions>();
    add_options(app, *options);
    return [options] { return sweep(*options); };
}

}  // namespace ropesim
