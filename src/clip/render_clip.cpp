#include "clip/render_clip.h"

#include "clip/file.h"
#include "clip/interrupt.h"
#include "clip/jobs.h"
#include "clip/manifest.h"
#include "clip/picture.h"
#include "clip/progress.h"
#include "image/png.h"

#include <algorithm>
#include <functional>
#include <stdexcept>
#include <system_error>

namespace ropesim {
namespace {

constexpr const char* manifest_name = "clip.json";

bool in_shard(long frame, const Shard& shard) {
    return frame % shard.count == shard.index;
}

std::vector<long> frames_of_shard(const std::vector<long>& frames, const Shard& shard) {
    std::vector<long> result;
    std::copy_if(frames.begin(), frames.end(), std::back_inserter(result),
                 [&](long f) { return in_shard(f, shard); });
    return result;
}

std::filesystem::path frame_path(const Scene& scene, const ClipOptions& options, long frame) {
    return options.folder / frame_name(frame, scene.frames);
}

// Whether the file is whole and was made by this very scene, version and frame.
bool is_made(const std::filesystem::path& path, const Texts& texts) {
    if (!std::filesystem::is_regular_file(path)) return false;
    try {
        return decode_png_texts(read_file(path), path.string()) == texts;
    } catch (const std::runtime_error&) {
        return false;  // cut off, or not even a PNG: to be made anew
    }
}

void write_frames(const Scene& scene, const Positions& positions, const ClipOptions& options,
                  const std::vector<long>& frames, Renderer& renderer,
                  const std::function<void()>& frame_done) {
    Texts texts = frame_texts(scene, options.positions_digest);
    for (const long frame : frames) {
        Interrupts::check();
        const Image& image = renderer.draw(polylines(scene, positions.at(frame)));
        set_frame(texts, frame);
        write_file(frame_path(scene, options, frame), encode_png(image, texts));
        frame_done();
    }
}

// Splits the frames so that every job has its share of them, whatever their numbers.
std::vector<long> share(const std::vector<long>& frames, std::size_t job, std::size_t jobs) {
    std::vector<long> result;
    for (std::size_t i = job; i < frames.size(); i += jobs) result.push_back(frames[i]);
    return result;
}

// What stands in the folder beside the frames that are asked for, and is not of this clip.
std::vector<std::string> leftovers(const Scene& scene, const ClipOptions& options) {
    std::vector<long> beyond;
    std::vector<long> of_others;
    Texts texts = frame_texts(scene, options.positions_digest);
    for (const long frame : frames_in(options.folder)) {
        set_frame(texts, frame);
        if (frame >= scene.frames)
            beyond.push_back(frame);
        else if (!std::binary_search(options.frames.begin(), options.frames.end(), frame) &&
                 !is_made(frame_path(scene, options, frame), texts))
            of_others.push_back(frame);
    }
    const std::string begin = options.folder.string() + " also holds frames ";
    std::vector<std::string> notes;
    if (!beyond.empty())
        notes.push_back(begin + "beyond the end of this clip, which has 0 to " +
                        std::to_string(scene.frames - 1) + ": " + to_string(beyond));
    if (!of_others.empty())
        notes.push_back(begin + "that this scene and version did not make: " + to_string(of_others));
    return notes;
}

}  // namespace

void prepare_folder(const ClipOptions& options) {
    std::error_code error;
    std::filesystem::create_directory(options.folder, error);
    if (error)
        throw std::runtime_error(options.folder.string() + ": cannot make the folder: " + error.message());
    if (!std::filesystem::is_directory(options.folder))
        throw std::runtime_error(options.folder.string() + ": expected a folder for the frames");
    remove_stale_temporaries(options.folder);
    const auto there = frames_of_shard(frames_in(options.folder), options.shard);
    if (options.existing == Existing::refuse && !there.empty())
        throw std::runtime_error(
            options.folder.string() + " already holds frames (" + to_string(there) +
            "); --resume keeps those of this clip, --overwrite makes them anew, -o names "
            "another folder");
    std::filesystem::remove(options.folder / manifest_name, error);  // until the frames are what it says
    if (error) throw std::runtime_error(options.folder.string() + ": cannot write: " + error.message());
}

ClipResult render_clip(const Scene& scene, const std::vector<Run>& runs,
                       const std::vector<Trajectory>& trajectories, const Positions& positions,
                       const ClipOptions& options) {
    ClipResult result;
    result.notes = leftovers(scene, options);
    std::vector<long> frames = frames_of_shard(options.frames, options.shard);
    if (options.existing == Existing::resume) {
        Texts texts = frame_texts(scene, options.positions_digest);
        result.kept = static_cast<long>(std::erase_if(frames, [&](long frame) {
            set_frame(texts, frame);
            return is_made(frame_path(scene, options, frame), texts);
        }));
    }
    result.written = static_cast<long>(frames.size());

    const Interrupts interrupts;
    Progress progress(result.written, options.show_progress);
    const auto work = [&](int job, const std::function<void()>& frame_done) {
        const auto jobs = static_cast<std::size_t>(options.jobs);
        const std::unique_ptr<Renderer> renderer = make_renderer(scene);
        write_frames(scene, positions, options, share(frames, static_cast<std::size_t>(job), jobs), *renderer,
                     frame_done);
        if (job == 0)
            write_file(options.folder / manifest_name,
                       clip_json(scene, runs, trajectories, options.positions_digest, options.frames,
                                 renderer->description()));
    };
    const auto frame_done = [&] { progress.frame_done(); };
    if (options.jobs > 1)
        in_processes(options.jobs, work, frame_done);
    else
        work(0, frame_done);
    return result;
}

}  // namespace ropesim
