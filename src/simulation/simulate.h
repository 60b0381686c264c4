#pragma once

#include "simulation/method.h"

#include <optional>
#include <vector>

namespace ropesim {

// How a rope moved. Where it diverged the frames end; nothing in it is ever non-finite.
struct Trajectory {
    std::vector<Points> frames;    // positions of frame 0 (the start), 1, 2, ...; world units, masses×2
    std::optional<long> diverged;  // the frame that the rope did not reach
    double largest_stretch =
        0.0;                    // greatest length of a link in any frame, divided by the rest length, less 1
    double energy_drift = 0.0;  // total energy of the last frame less that of the first
};

// Runs the rope from rest over `frames` frames, frame 0 included. A rope has diverged where a coordinate is
// not finite or a link longer than `sensible_length`.
Trajectory simulate(const Rope& rope, const Method& method, const Stepping& stepping, long frames);

// A length that no link comes near in a stable run, by time t: a thousand times the rope's length and the
// way that free fall takes.
double sensible_length(const Rope& rope, double time);

}  // namespace ropesim
