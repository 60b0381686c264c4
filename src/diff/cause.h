#pragma once

#include "diff/compare.h"
#include "diff/motion.h"
#include "diff/scene_keys.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace ropesim {

// Why frames differ.
struct Cause {
    // What it is, the most telling first: "shift" (frames of another time), "scene", "motion", "drawing",
    // "less", "more" or "color" (what pixels alone tell), "missing", "extra", "size", "unreadable",
    // "file-format", "unknown".
    std::vector<std::string> kinds;
    std::vector<std::string> sentences;         // the same at length
    std::vector<KeyDifference> keys;            // of the scenes, where both are known
    MotionDifference motion;                    // where positions of both sides are known
    std::optional<long> unpredictable;          // the first frame that nobody can predict, where masses moved
    std::map<std::string, std::string> frames;  // name of a frame to "motion", "drawing" or both
};

// Looks for scenes in the frames (else clip.json, else scene.toml beside them) and for positions.csv or
// positions.npy beside them; else simulates the scenes where they differ. What cannot be known is left out.
Cause cause(const Comparison& comparison);

// Frames of one and the same scene that nobody can predict, and that differ as the masses moved, pass: a
// rounding, of another compiler or version, is enough to make them differ. All else stays as it was.
void excuse_chaos(const Cause& cause, Comparison& comparison);

}  // namespace ropesim
