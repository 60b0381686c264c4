#pragma once

#include "clip/positions.h"
#include "diff/compare.h"

#include <optional>
#include <string>

namespace ropesim {

// What is known of the clip that the frames of one side come from.
struct Side {
    std::optional<Scene> scene;
    std::optional<Positions> positions;  // of a file beside the frames
    bool drawn_from_positions = false;   // of a file that may be anywhere
    std::string problem;                 // why what is there could not be read
};

enum class Which { expected, actual };

// The scene is that of the first frame that differs and carries one, else of clip.json, else of scene.toml;
// the positions those of positions.csv or positions.npy.
Side side(const Comparison& comparison, Which which);

// Reads positions.csv or positions.npy beside the frames of a side, where there is one, as of its scene.
void read_positions(const Comparison& comparison, Which which, Side& side);

}  // namespace ropesim
