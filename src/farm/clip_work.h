#pragma once

#include "scene/scene.h"

namespace ropesim {

// What a clip takes, in evaluations of the acceleration of one mass: estimated by counts, so that it is the
// same everywhere. The scene's methods are known, not "auto".
struct ClipWork {
    double simulating = 0.0;       // from the first frame to the last
    double drawing = 0.0;          // of all frames
    double positions_bytes = 0.0;  // of all frames' positions in a .npy file

    // The share of simulating in what one of so many shards takes: it simulates all and draws its frames.
    double simulating_share(long shards) const;
};
ClipWork clip_work(const Scene& scene);

// Whether positions should be simulated once, for all shards to read: each would simulate more than it
// draws, and the file, which each reads whole to check it, is of no more than 16 GiB.
bool worth_simulating_once(const ClipWork& work, long shards);

}  // namespace ropesim
