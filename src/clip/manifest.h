#pragma once

#include "clip/frames.h"
#include "clip/simulation.h"
#include "image/png.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ropesim {

struct ClipOptions;

// The text chunks that say what made a frame: scene, its digest, frame, methods, version, and the digest
// of the positions file if there was one. Two frames with equal texts are the same picture.
Texts frame_texts(const Scene& scene, const std::string& positions_digest);  // of all frames of a clip
void set_frame(Texts& texts, long frame);

// The scene in a frame's texts. Throws std::runtime_error, "<name>: why", where there is none.
Scene scene_of(const Texts& texts, const std::string& name);

// The digest of the scene, and the number, that a frame's texts give; "" where they give none.
std::string scene_digest_of(const Texts& texts);
std::string frame_of(const Texts& texts);

// The version of the program that made a frame, as its texts give it; "" where they give none.
std::string version_of(const Texts& texts);

// The digest of the positions file that the frame was drawn from; "" where the scene was simulated.
std::string positions_digest_of(const Texts& texts);

// clip.json: the scene as rendered, versions, the renderer, the frames that the folder has, and per rope the
// method, its steps, and, unless positions were given, where it diverged and why, its largest stretch and
// tension, and its energy in the first frame and the last.
std::string clip_json(const Scene& scene, const Simulation& simulation, const ClipOptions& options,
                      const FrameList& frames, const std::string& renderer);

// What clip.json says that the clip is.
struct Manifest {
    std::string version;  // of the program that made it
    std::string digest;   // of the scene
    Scene scene;
    std::string positions_digest;
    FrameList frames;
    bool compact = false;     // whether files are small rather than fast
    bool has_errors = false;  // whether errors were estimated
};

// Reads and checks clip.json. Throws std::runtime_error, "<name>: what was found, what was expected".
Manifest parse_manifest(std::string_view json, const std::string& name);

// The file's place in the folder of the clip.
std::filesystem::path manifest_path(const std::filesystem::path& folder);

// Throws std::runtime_error where it is there and cannot be removed.
void remove_manifest(const std::filesystem::path& folder);

// "ropesim 0.1.0"
std::string version();

}  // namespace ropesim
