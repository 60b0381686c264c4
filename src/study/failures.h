#pragma once

#include "study/stability.h"

#include <optional>
#include <vector>

namespace ropesim {

// A run of a method at a step, and moments of it that show what becomes of it.
struct Showing {
    struct Moment {
        long frame = 0;
        double error = 0.0;  // pixels
        Points position;     // world units, masses×2
    };
    long steps = 0;                // per frame
    double worst = 0.0;            // pixels, over the believed frames; infinite where it did not reach them
    std::optional<long> diverged;  // the frame that it did not reach
    std::vector<Moment> moments;
};

// Where a method ceases to hold: the fewest steps per frame at which it holds, as it does at all finer ones,
// and the next fewer, at which it fails. It holds where it is usable (quality(worst)).
struct Failure {
    const Method* method = nullptr;
    std::optional<Showing> holds;  // none where it does not at 4096 steps
    std::optional<Showing> fails;  // none where it holds at one step
};

// Of each method, by halving between powers of sqrt(2). A run that holds is shown after each third of the
// clip; one that fails half the way to the first frame where it is too far off, there, and at its end.
std::vector<Failure> failures(const Problem& problem, const Truth& truth,
                              const std::vector<const Method*>& methods, const MapReport& report);

}  // namespace ropesim
