#include "clip/frames.h"
#include "clip/manifest.h"
#include "clip/run.h"
#include "clip/video.h"
#include "commands/batch_options.h"
#include "commands/commands.h"
#include "commands/scene_options.h"
#include "farm/clip_work.h"
#include "study/plan.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>

namespace ropesim {
namespace {

struct SubmitOptions {
    SceneOptions scene;
    std::filesystem::path folder = "frames";
    BatchOptions batch;
    std::string video;
    bool resume = false;
};

void add_options(CLI::App& app, SubmitOptions& options) {
    add_scene_options(app, options.scene);
    app.add_option("-o,--output", options.folder, "folder for the frames, which all nodes share")
        ->type_name("DIR")
        ->capture_default_str();
    add_batch_options(app, options.batch);
    app.get_option("--shards")->required();
    app.add_option("--video", options.video,
                   "make a video of the frames in the end (.mp4 or .gif, by ffmpeg)")
        ->type_name("FILE");
    app.add_flag("--resume", options.resume, "keep the frames that this very scene and version made");
    app.footer(
        "An array of tasks renders the frames, then a job makes good what failed ones left and looks at "
        "every\n"
        "frame. Scene, scripts and logs are kept in DIR/batch. Without a scheduler: ropesim render --jobs\n"
        "Examples:\n"
        "  ropesim submit my.toml -o /shared/clip --shards 64 --video /shared/clip.mp4\n"
        "  ropesim submit my.toml -o /shared/clip --shards 64 --dry-run");
}

std::string percent(double share) {
    return std::to_string(std::lround(100.0 * share)) + " %";
}

// Says why.
bool simulates_once(const Scene& scene, long shards) {
    const ClipWork work = clip_work(scene);
    const bool once = worth_simulating_once(work, shards);
    const double share = work.simulating_share(shards);
    std::fprintf(stderr, "ropesim: simulating is %s of a task's work: %s\n", percent(share).c_str(),
                 once          ? "one job does it, the others read its positions"
                 : share > 0.5 ? "but each task does it, positions would be more than 16 GiB"
                               : "each task does it");
    return once;
}

std::vector<BatchJob> jobs(const SubmitOptions& options, const std::filesystem::path& folder, bool once) {
    const std::string program = this_program();
    const std::filesystem::path batch = folder / "batch";
    const std::string scene = shell_word((batch / "scene.toml").string());
    const std::string positions = shell_word((batch / "positions.npy").string());
    const std::string frames = shell_word(folder.string());
    const std::string from = once ? " --positions " + positions : "";
    const std::string render =
        program + " render " + scene + " -o " + frames + from + " --resume --jobs 1 --quiet";
    const std::string shards = std::to_string(options.batch.request.shards);
    std::vector<BatchJob> jobs;
    if (once)
        jobs.push_back({"simulate",
                        "Simulates once for all tasks.",
                        false,
                        {program + " simulate " + scene + " -o " + positions}});
    jobs.push_back({"render",
                    "Task I of " + shards + " makes the frames whose number is I modulo " + shards + ".",
                    true,
                    {"exec " + render + " --shard \"$SLURM_ARRAY_TASK_ID/" + shards + '"'},
                    once});
    jobs.push_back({"gather",
                    "Makes good what failed tasks left; looks at every frame.",
                    false,
                    {"[ -e " + shell_word((folder / "clip.json").string()) + " ] || " + render,
                     program + " verify " + frames + " --repair" + from}});
    if (!options.video.empty())
        jobs.back().commands.push_back(render + " --video " +
                                       shell_word(std::filesystem::absolute(options.video).string()));
    return jobs;
}

// Until the frames are what clip.json says it goes; frames that are there are a matter to be decided.
void prepare(const SubmitOptions& options, const std::filesystem::path& folder) {
    if (!std::filesystem::is_directory(folder)) return;
    if (!options.resume && !frames_in(folder).empty())
        throw std::runtime_error(folder.string() +
                                 " already holds frames; --resume keeps those of this clip, -o names another "
                                 "folder");
    std::filesystem::remove(folder / "clip.json");
}

int submit_clip(const SubmitOptions& options) {
    const FoundScene found = open_scene(options.scene);
    if (!found.positions_digest.empty())
        throw std::runtime_error(options.scene.scene + ": was drawn from a positions file; expected a scene");
    const Scene scene = with_planned_ropes(found.scene);
    for (const std::string& warning : stability_warnings(scene, runs(scene)))
        std::fprintf(stderr, "ropesim: warning: %s\n", warning.c_str());
    if (!options.video.empty()) check_video(options.video, selected_frames("", scene));
    const std::filesystem::path folder = std::filesystem::absolute(options.folder).lexically_normal();
    if (!options.batch.dry_run) {
        require_sbatch("ropesim render " + options.scene.scene + " -o " + options.folder.string() +
                       " --jobs 2");
        prepare(options, folder);
    }
    const bool once = simulates_once(scene, options.batch.request.shards);
    hand_over(options.batch, jobs(options, folder, once), folder / "batch", to_toml(scene));
    return 0;
}

}  // namespace

Command submit_command(CLI::App& app) {
    const auto options = std::make_shared<SubmitOptions>();
    add_options(app, *options);
    return [options] { return submit_clip(*options); };
}

}  // namespace ropesim
