#pragma once

#include "simulation/diagnostics.h"
#include "simulation/method.h"

#include <optional>
#include <vector>

namespace ropesim {

// How a rope moved. Where it diverged the frames end; nothing in it is ever non-finite.
struct Trajectory {
    std::vector<Points> frames;  // positions of frame 0 (the start), 1, 2, ...; world units, masses×2
    std::vector<Diagnostics> diagnostics;  // of each frame
    std::optional<long> diverged;          // the frame that the rope did not reach
    Cost cost;                             // of all frames, that of a diverged one included

    double largest_stretch() const;  // in any frame
    double largest_tension() const;  // in any frame
    double energy_drift() const;     // total energy of the last frame less that of the first
};

// Runs the rope from rest over `frames` frames, frame 0 included. A rope has diverged where a coordinate is
// not finite or a link longer than `sensible_length`.
Trajectory simulate(const Rope& rope, const Method& method, const Stepping& stepping, long frames);

// A length that no link comes near in a stable run, by time t: a thousand times the rope's length and the
// way that free fall takes.
double sensible_length(const Rope& rope, double time);

}  // namespace ropesim
