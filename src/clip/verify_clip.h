#pragma once

#include "clip/frames.h"
#include "clip/manifest.h"

#include <filesystem>
#include <string>
#include <vector>

namespace ropesim {

// What is wrong with a frame, or alike with all of several.
struct FrameFault {
    FrameList::Range frames;
    std::string what;  // "missing", "broken: why", "of another scene", ...
};

// Looks at these frames of the clip, pixels and all, in as many threads: whether each is there, whole, of the
// manifest's scene and version, and has its own number.
std::vector<FrameFault> find_faults(const std::filesystem::path& folder, const Manifest& manifest,
                                    const FrameList& frames, int threads, bool show_progress);

struct Verification {
    Manifest manifest;                          // of the folder's clip.json
    std::vector<FrameFault> faults;             // by frame
    FrameList unnamed;                          // frames in the folder that clip.json does not name
    std::vector<std::filesystem::path> strays;  // temporary files of nobody who is at work here
};

// Looks at every frame that clip.json names. Throws std::runtime_error where clip.json is missing or broken.
Verification verify_clip(const std::filesystem::path& folder, int threads, bool show_progress);

// The frames that have a fault.
FrameList faulty_frames(const Verification& verification);

// A line for every fault and stray file, of faults at most as many, then how many more there are.
std::string fault_lines(const std::filesystem::path& folder, const Verification& verification,
                        std::size_t most);

}  // namespace ropesim
