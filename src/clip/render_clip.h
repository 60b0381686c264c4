#pragma once

#include "clip/folder_lock.h"
#include "clip/frames.h"
#include "clip/positions_file.h"
#include "clip/simulation.h"
#include "scene/scene.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ropesim {

// What to do where the folder holds frames already.
enum class Existing {
    refuse,     // throw
    resume,     // keep those that this very scene, version and frame made; make the others anew
    overwrite,  // make all anew
};

struct ClipOptions {
    std::filesystem::path folder = "frames";
    FrameList frames;         // which of the scene's
    Shard shard;              // of those, the ones whose number falls to this shard
    std::optional<int> jobs;  // processes; without it, as many as make the clip faster here
    Existing existing = Existing::refuse;
    bool compact = false;  // small files rather than fast ones
    bool sync = false;     // have each frame outlast a power cut, before it has its name
    bool show_progress = false;
    std::string positions_digest;  // of the file that the positions came from, if any
};

struct ClipResult {
    long written = 0;
    long kept = 0;                   // found there by --resume
    std::vector<std::string> notes;  // what a user should know, such as frames of a longer clip left over
};

// Makes the folder where needed and keeps others out of it, for as long as the lock is kept. Throws
// std::runtime_error where its parent is missing, it is no folder, another process is writing there, or it
// holds frames and `existing` says refuse.
[[nodiscard]] FolderLock prepare_folder(const Scene& scene, const ClipOptions& options);

// Renders the frames into the folder, where the simulation (in frame 0) takes the ropes or where `given` says
// they are, then writes clip.json, which needs the simulation to go to the scene's last frame. It names these
// frames, of all shards, and those of a clip.json of the same clip that was there. Throws std::runtime_error
// (the disk is full, no OpenGL context, ...) and Interrupted; what is there then is whole, and `resume` goes
// on from it.
ClipResult render_clip(const Scene& scene, Simulation& simulation, const PositionsFile* given,
                       const ClipOptions& options);

}  // namespace ropesim
