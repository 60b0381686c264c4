#pragma once

#include "simulation/rope.h"

#include <vector>

namespace ropesim {

// A motion from rest, sampled at the frames, as one integrator found it. Where the integrator could not go
// on, the frames end.
struct Run {
    std::vector<Points> position;  // of frame 0 (the start), 1, 2, ...; world units, masses×2
    std::vector<Points> velocity;  // world units per unit of time, masses×2
};

}  // namespace ropesim
