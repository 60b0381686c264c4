#include "clip/pace.h"
#include "clip/positions_file.h"
#include "clip/render_clip.h"
#include "clip/verify_clip.h"
#include "commands/commands.h"
#include "scene/words.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>
#include <vector>

namespace ropesim {
namespace {

struct VerifyOptions {
    std::string folder;
    bool repair = false;
    std::string positions;
    std::optional<int> jobs;
    bool quiet = false;
};

void add_options(CLI::App& app, VerifyOptions& options) {
    app.add_option("DIR", options.folder, "a folder of frames, with the clip.json that render left")
        ->required()
        ->type_name("");
    CLI::Option* repair = app.add_flag("--repair", options.repair, "render the frames that are not right");
    app.add_option("--positions", options.positions,
                   "the positions file that the clip was drawn from, for --repair")
        ->type_name("FILE")
        ->needs(repair);
    app.add_option("--jobs", options.jobs, "threads that look, processes that repair")
        ->type_name("N")
        ->check(CLI::Range(1, 1024).description(""));
    app.add_flag("--quiet", options.quiet, "say nothing but errors");
    app.footer(
        "A frame is right where it is there, whole, of clip.json's scene and version, and has its own "
        "number.\n"
        "Exit status: 0 all are right (or repaired), 1 some are not, 2 wrong usage.\n"
        "Examples:\n"
        "  ropesim verify frames\n"
        "  ropesim verify frames --repair --jobs 4");
}

std::string counted(std::size_t frames) {
    return std::to_string(frames) + (frames == 1 ? " frame" : " frames");
}

void say_what_is_wrong(const VerifyOptions& options, const Verification& verification) {
    constexpr std::size_t screenful = 20;  // lines
    if (options.quiet) return;
    std::fputs(fault_lines(options.folder, verification, screenful).c_str(), stdout);
    if (!verification.unnamed.empty())
        std::printf("%s also holds frames that its clip.json does not name: %s\n",
                    one_line(options.folder).c_str(), to_string(verification.unnamed).c_str());
}

// The positions that the clip was drawn from; none where it was simulated.
std::unique_ptr<PositionsFile> given_positions(const VerifyOptions& options, const Manifest& manifest,
                                               const FrameList& frames) {
    if (manifest.positions_digest.empty()) {
        if (!options.positions.empty())
            throw std::runtime_error(options.folder +
                                     ": was simulated, not drawn from positions; leave out --positions");
        return nullptr;
    }
    if (options.positions.empty())
        throw std::runtime_error(options.folder +
                                 ": was drawn from a positions file; give that file by --positions");
    auto file = std::make_unique<PositionsFile>(manifest.scene, options.positions);
    if (file->digest() != manifest.positions_digest)
        throw std::runtime_error(options.positions + ": is not the file that " + options.folder +
                                 " was drawn from");
    file->check_has(frames);
    return file;
}

void repair(const VerifyOptions& options, const Manifest& manifest, const FrameList& frames) {
    if (manifest.version != version())
        throw std::runtime_error(options.folder + ": was made by " + printable(manifest.version) +
                                 ", this is " + version() + "; make it anew by render --overwrite");
    ClipOptions clip;
    clip.folder = options.folder;
    clip.frames = frames;
    clip.jobs = options.jobs;
    clip.existing = Existing::overwrite;
    clip.compact = manifest.compact;
    clip.show_progress = !options.quiet;
    clip.positions_digest = manifest.positions_digest;
    const std::unique_ptr<PositionsFile> given = given_positions(options, manifest, frames);
    const FolderLock lock = prepare_folder(manifest.scene, clip);
    if (frames.empty()) return;
    Simulation simulation(manifest.scene,
                          manifest.has_errors ? Simulation::Errors::estimated : Simulation::Errors::left_out);
    render_clip(manifest.scene, simulation, given.get(), clip);
    const std::vector<FrameFault> left =
        find_faults(options.folder, manifest, frames, options.jobs.value_or(processors()), false);
    if (!left.empty())
        throw std::runtime_error(options.folder + ": not repaired, frame " +
                                 std::to_string(left.front().frames.first) + " is " + left.front().what);
}

int verify(const VerifyOptions& options) {
    const Verification verification =
        verify_clip(options.folder, options.jobs.value_or(processors()), !options.quiet);
    say_what_is_wrong(options, verification);
    const FrameList faulty = faulty_frames(verification);
    const std::size_t frames = verification.manifest.frames.size();
    if (!faulty.empty() && !options.repair)
        throw std::runtime_error(options.folder + ": " + std::to_string(faulty.size()) + " of " +
                                 counted(frames) + " not right; --repair renders just those");
    if (options.repair) repair(options, verification.manifest, faulty);
    if (options.quiet) return 0;
    if (!faulty.empty())
        std::printf("rendered %s anew: %s\n", counted(faulty.size()).c_str(), to_string(faulty).c_str());
    std::printf("%s in %s: all there, whole and of one clip\n", counted(frames).c_str(),
                one_line(options.folder).c_str());
    return 0;
}

}  // namespace

Command verify_command(CLI::App& app) {
    const auto options = std::make_shared<VerifyOptions>();
    add_options(app, *options);
    return [options] { return verify(*options); };
}

}  // namespace ropesim
