#include "clip/file.h"
#include "clip/frames.h"
#include "clip/interrupt.h"
#include "clip/manifest.h"
#include "clip/positions_file.h"
#include "clip/render_clip.h"
#include "clip/video.h"
#include "commands/commands.h"
#include "commands/scene_options.h"
#include "scene/words.h"
#include "study/plan.h"

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>

namespace ropesim {
namespace {

struct RenderOptions {
    SceneOptions scene;
    std::string folder = "frames";
    std::string frames;
    std::string size;
    std::optional<int> jobs;
    std::string shard = "0/1";
    bool resume = false;
    bool overwrite = false;
    bool compact = false;
    bool sync = false;
    std::string positions;
    std::string video;
    bool strict = false;
    bool quiet = false;
};

void add_options(CLI::App& app, RenderOptions& options) {
    add_scene_options(app, options.scene);
    app.add_option("-o,--output", options.folder, "folder for the frames; made where it is missing")
        ->type_name("DIR")
        ->capture_default_str();
    app.add_option("--frames", options.frames, "only these frames, such as 2,4,10:20,90: (ends included)")
        ->type_name("LIST");
    app.add_option("--size", options.size, "size of the picture in pixels, such as 1280x720")
        ->type_name("WxH");
    app.add_option("--jobs", options.jobs,
                   "processes that share the frames; by default, as many as make the clip faster")
        ->type_name("N")
        ->check(CLI::Range(1, 1024).description(""));
    app.add_option("--shard", options.shard, "only frames whose number is I modulo N")->type_name("I/N");
    CLI::Option* resume =
        app.add_flag("--resume", options.resume, "keep the frames that this very scene and version made");
    app.add_flag("--overwrite", options.overwrite, "make all frames anew")->excludes(resume);
    app.add_flag("--compact", options.compact, "make files smaller than libpng would, but slowly");
    app.add_flag("--sync", options.sync, "have every frame on the disk, not in memory, before the next");
    app.add_option("--positions", options.positions,
                   "draw these positions (.csv or .npy) instead of simulating")
        ->type_name("FILE");
    app.add_option("--video", options.video, "make a video of the frames, too (.mp4 or .gif, by ffmpeg)")
        ->type_name("FILE");
    add_error_option(app, options.scene);
    app.add_flag("--strict", options.strict, "exit with status 1 where a rope diverges");
    app.add_flag("--quiet", options.quiet, "say nothing but errors");
    app.footer(
        "Examples:\n"
        "  ropesim render                              two ropes into frames/\n"
        "  ropesim render -s 8 -o blown-up             the same with 8 steps per frame\n"
        "  ropesim render my.toml --video my.mp4\n"
        "  ropesim render frames/frame_0042.png -o again");
}

void set_size(Scene& scene, const std::string& text) {
    if (text.empty()) return;
    int read = 0;
    const bool plain = text.find_first_not_of("0123456789x") == std::string::npos;
    // NOLINTNEXTLINE(cert-err34-c): seven digits fit, and an end elsewhere is told by the count read
    if (!plain || std::sscanf(text.c_str(), "%7dx%7d%n", &scene.size[0], &scene.size[1], &read) != 2 ||
        static_cast<std::size_t>(read) != text.size())
        throw CLI::ValidationError("--size", "'" + text + "' is no size; expected WxH, such as 1280x720");
    try {
        check_scene(scene);
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(std::string("--size: ") + error.what());
    }
}

void warn(bool quiet, const std::string& sentence) {
    if (!quiet) std::fprintf(stderr, "ropesim: %s\n", one_line(sentence).c_str());
}

// Every frame that the file holds is drawn where none are asked for.
std::unique_ptr<PositionsFile> given_positions(const Scene& scene, const RenderOptions& options,
                                               ClipOptions& clip) {
    if (options.positions.empty()) return nullptr;
    auto file = std::make_unique<PositionsFile>(scene, options.positions);
    clip.positions_digest = file->digest();
    if (options.frames.empty()) clip.frames = file->frames();
    if (clip.frames.empty()) throw std::runtime_error(options.positions + ": holds no frame");
    file->check_has(clip.frames);
    return file;
}

bool report_divergence(const Scene& scene, const Simulation& simulation, bool quiet) {
    bool any = false;
    for (std::size_t i = 0; i < simulation.runs().size(); ++i) {
        const auto diverged = simulation.diverged(i);
        if (!diverged) continue;
        warn(quiet, divergence(scene, simulation.runs()[i], *diverged));
        any = true;
    }
    return any;
}

void report_done(const ClipResult& result, const std::string& folder, double seconds, bool quiet) {
    for (const std::string& note : result.notes) warn(quiet, note);
    if (quiet) return;
    std::printf("%ld frame%s in %s%s, %.2f s", result.written, result.written == 1 ? "" : "s",
                one_line(folder).c_str(), folder.ends_with('/') ? "" : "/", seconds);
    if (result.written > 0)
        std::printf(" (%.0f frames per second)", static_cast<double>(result.written) / seconds);
    if (result.kept > 0) std::printf("; %ld were there already", result.kept);
    std::printf("\n");
}

void say(const std::string& line) {
    if (!line.empty()) std::printf("%s\n", line.c_str());
}

void say_what_was_planned(const Scene& as_written, const Scene& planned) {
    for (std::size_t i = 0; i < planned.ropes.size(); ++i)
        if (as_written.ropes[i].method == auto_method)
            std::printf("rope '%s': planned %s, %d steps per frame\n", planned.ropes[i].name.c_str(),
                        planned.ropes[i].method.c_str(), steps_per_frame(planned, planned.ropes[i]));
}

// What a long clip must not find out at its end. The folder of the frames is yet to be made.
void check_video_file(const RenderOptions& options) {
    const auto folder_of = [](const std::filesystem::path& file) {
        return std::filesystem::absolute(file).lexically_normal().parent_path();
    };
    if (folder_of(options.video) != folder_of(options.folder + "/frame")) check_writable(options.video);
}

int render(const RenderOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    FoundScene found = open_scene(options.scene);
    Scene& scene = found.scene;
    set_size(scene, options.size);
    const Scene as_written = scene;
    scene = with_planned_ropes(scene);
    if (!options.quiet) say_what_was_planned(as_written, scene);
    if (!found.positions_digest.empty() && options.positions.empty())
        throw std::runtime_error(options.scene.scene +
                                 ": was drawn from a positions file; give that file by --positions");
    ClipOptions clip;
    clip.folder = options.folder;
    clip.frames = selected_frames(options.frames, scene);
    clip.shard = selected_shard(options.shard);
    clip.jobs = options.jobs;
    clip.existing = options.resume      ? Existing::resume
                    : options.overwrite ? Existing::overwrite
                                        : Existing::refuse;
    clip.compact = options.compact;
    clip.sync = options.sync;
    clip.show_progress = !options.quiet;
    if (!options.video.empty() && clip.shard.count > 1)
        throw CLI::ValidationError("--video",
                                   "a shard has only some of the frames; --resume --video makes it of all");
    const std::unique_ptr<PositionsFile> given = given_positions(scene, options, clip);
    if (!options.video.empty()) {
        check_video(options.video, clip.frames);
        check_video_file(options);
    }
    const FolderLock lock = prepare_folder(scene, clip);
    Simulation simulation(scene, !given && !options.scene.no_error ? Simulation::Errors::estimated
                                                                   : Simulation::Errors::left_out);
    if (!given)
        for (const std::string& warning : stability_warnings(scene, simulation.runs()))
            warn(options.quiet, "warning: " + warning);
    const ClipResult result = render_clip(scene, simulation, given.get(), clip);
    if (!options.video.empty()) write_video(options.video, clip.folder, clip.frames, scene.frames);
    const bool diverged = report_divergence(scene, simulation, options.quiet && !options.strict);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    report_done(result, options.folder, seconds, options.quiet);
    if (!options.quiet) say(error_line(simulation));
    return diverged && options.strict ? 1 : 0;
}

}  // namespace

Command render_command(CLI::App& app) {
    const auto options = std::make_shared<RenderOptions>();
    add_options(app, *options);
    return [options] { return render(*options); };
}

}  // namespace ropesim
