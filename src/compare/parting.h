#pragma once

#include "scene/scene.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ropesim {

// How far a run's masses are from those of the first run, pixels.
struct Apart {
    double greatest = 0.0;
    double mean = 0.0;
};

// One run in one frame.
struct ComparedFrame {
    std::optional<Apart> apart;    // none where one of the two has diverged
    double farthest = 0.0;         // the greatest distance in this frame and those before, pixels
    std::optional<double> energy;  // kinetic, spring and gravity's together, scene units; none where diverged
};

// How runs part, frame by frame; all against the first.
struct Parting {
    std::vector<std::vector<ComparedFrame>> frames;  // of each frame of the scene: one per run
    std::vector<std::optional<long>> diverged;       // of each run
};

// Runs the ropes of a compared scene over its frames.
Parting parting(const Scene& scene);

// A line for every frame and run but the first, against the first.
std::string to_csv(const Scene& scene, const Parting& parting);

// "'Verlet' parts from 'Euler' by more than a pixel in frame 12; farthest apart in frame 119, by 36 px", a
// line for every run but the first.
std::vector<std::string> summaries(const Scene& scene, const Parting& parting);

}  // namespace ropesim
