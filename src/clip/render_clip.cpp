#include "clip/render_clip.h"

#include "clip/digest.h"
#include "clip/file.h"
#include "clip/helpers.h"
#include "clip/interrupt.h"
#include "clip/manifest.h"
#include "clip/pace.h"
#include "clip/picture.h"
#include "clip/progress.h"
#include "image/compact_png.h"
#include "image/frame_encoder.h"
#include "image/png.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <ranges>
#include <stdexcept>
#include <system_error>

namespace ropesim {
namespace {

std::filesystem::path frame_path(const Scene& scene, const ClipOptions& options, long frame) {
    return options.folder / frame_name(frame, scene.frames);
}

FrameList in_shard(const FrameList& frames, const Shard& shard) {
    std::vector<long> result;
    std::ranges::copy_if(frames, std::back_inserter(result), [&](long f) { return shard.contains(f); });
    return result;
}

// Whether the file is whole and was made by this very scene, version and frame.
bool is_made(const std::filesystem::path& path, const Texts& texts) {
    try {
        return decode_png_texts(read_regular_file(path), path.string()) == texts;
    } catch (const std::runtime_error&) {
        return false;  // missing, cut off, or not even a PNG: to be made anew
    }
}

template <class Content>
void write_whole(const std::filesystem::path& path, const Content& content, const ClipOptions& options) {
    NewFile file(path);
    file.append(content);
    if (options.sync) file.sync();
    file.finish();
}

// Draws frames and writes them; has an OpenGL context from the first on.
class FrameWriter {
  public:
    FrameWriter(const Scene& scene, const ClipOptions& options)
        : scene_(scene),
          options_(options),
          texts_(frame_texts(scene, options.positions_digest)),
          encoder_(scene.size[0], scene.size[1]) {}

    void write(long frame, const std::vector<Points>& positions) {
        const Image& image = renderer().draw(polylines(scene_, positions));
        set_frame(texts_, frame);
        write_whole(frame_path(scene_, options_, frame),
                    options_.compact
                        ? encode_compact_png(image, texts_)
                        : encoder_.encode(image, renderer().inked(), renderer().changed(), texts_),
                    options_);
    }

    // Whether the frame is there, whole, and made by this very scene and version.
    bool has_written(long frame) {
        set_frame(texts_, frame);
        return is_made(frame_path(scene_, options_, frame), texts_);
    }

    Renderer& renderer() {
        if (!renderer_) renderer_ = make_renderer(scene_);
        return *renderer_;
    }

  private:
    const Scene& scene_;
    const ClipOptions& options_;
    Texts texts_;
    FrameEncoder encoder_;
    std::unique_ptr<Renderer> renderer_;
};

// Where nobody said how many jobs, they wait, and cost next to nothing, until it shows that they are worth
// it. One that would draw fewer frames than this would not be.
int most_helpers(const std::optional<int>& jobs, long frames) {
    constexpr long least_frames = 8;
    const long most =
        jobs ? std::min<long>(*jobs, frames) - 1 : std::min<long>(processors() - 1, frames / least_frames);
    return static_cast<int>(std::max(0L, most));
}

void advance_to(long frame, Simulation& simulation) {
    for (; simulation.frame() < frame; simulation.advance()) Interrupts::check();
}

// The frames that clip.json names, where it is there and of this very clip; otherwise it is taken away.
FrameList frames_known(const Scene& scene, const ClipOptions& options) {
    const std::filesystem::path path = manifest_path(options.folder);
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) return {};
    const std::vector<std::uint8_t> bytes = read_regular_file(path);
    try {
        const Manifest manifest =
            parse_manifest({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path.string());
        if (manifest.version == version() && manifest.scene == scene &&
            manifest.positions_digest == options.positions_digest)
            return manifest.frames;
    } catch (const std::runtime_error&) {  // NOLINT(bugprone-empty-catch): as if there were none
        // it is no clip.json that anyone could go by
    }
    remove_manifest(options.folder);
    return {};
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
        else if (!options.frames.contains(frame) && !is_made(frame_path(scene, options, frame), texts))
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

FolderLock prepare_folder(const Scene& scene, const ClipOptions& options) {
    make_folder(options.folder);
    const bool alone = options.shard.count == 1;
    FolderLock lock(options.folder,
                    alone ? "" : digest(version() + options.positions_digest + to_toml(scene)));
    remove_stale_temporaries(options.folder);
    const FrameList there = in_shard(frames_in(options.folder), options.shard);
    if (options.existing == Existing::refuse && !there.empty())
        throw std::runtime_error(
            options.folder.string() + " already holds frames (" + to_string(there) +
            "); --resume keeps those of this clip, --overwrite makes them anew, -o names "
            "another folder");
    return lock;
}

ClipResult render_clip(const Scene& scene, Simulation& simulation, const PositionsFile* given,
                       const ClipOptions& options) {
    ClipResult result;
    result.notes = leftovers(scene, options);
    const FrameList known = frames_known(scene, options);
    const Interrupts interrupts;
    FrameWriter writer(scene, options);
    const auto wanted = [&](long frame) { return options.shard.contains(frame); };
    long left = std::ranges::count_if(options.frames, wanted);
    Progress progress(left, "frames", options.show_progress);
    Helpers helpers(most_helpers(options.jobs, left), simulation.positions(),
                    [&](long frame, const auto& at) { writer.write(frame, at); });
    int at_work = options.jobs ? helpers.count() : 0;
    Pace pace;
    std::vector<Points> read;
    for (const long frame : options.frames | std::views::filter(wanted)) {
        Interrupts::check();
        --left;
        if (options.existing == Existing::resume && writer.has_written(frame)) {
            ++result.kept;
            progress.kept();
            continue;
        }
        if (!given) advance_to(frame, simulation);
        if (given) read = given->at(frame);
        const std::vector<Points>& positions = given ? read : simulation.positions();
        if (!helpers.take(frame, positions, at_work)) {
            const auto start = std::chrono::steady_clock::now();
            writer.write(frame, positions);
            pace.add_frame(std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
            progress.done(1);
            at_work = std::max(at_work, pace.worthwhile_helpers(left));
        }
        progress.done(helpers.drawn());
        ++result.written;
    }
    if (!given) advance_to(scene.frames - 1, simulation);
    helpers.finish();
    if (helpers.any_died()) remove_stale_temporaries(options.folder);
    if (options.sync) sync_folder(options.folder);
    write_whole(
        manifest_path(options.folder),
        clip_json(scene, simulation, options, both(known, options.frames), writer.renderer().description()),
        options);
    if (options.sync) {
        sync_folder(options.folder);
        sync_folder(options.folder / "..");  // which has the folder's own name
    }
    return result;
}

}  // namespace ropesim
