#pragma once

#include "simulation/bundle.h"
#include "simulation/instruction_set.h"

#include <vector>

namespace ropesim {

struct Cost;
struct Scratch;
struct Stepping;

// What moves a mass once its acceleration a is known: a kick, then a drift,
//   v' = after (before v + kick a),   x' = x + drift v',   v'' = kept v'.
// Without a kick, a drift alone.
struct Leap {
    double before = 1.0;
    double kick = 0.0;  // units of time
    double after = 1.0;
    double drift = 0.0;  // units of time
    double kept = 1.0;
};

// The steps of a splitting method: each is `opening`, which goes by the acceleration that the step before
// ended with, and then the leaps `of_step`, one at least. Where the opening kicks, so does the last of them.
// Velocities are those of the state times `velocity_unit`.
struct Leaps {
    Leap opening{};  // none where it neither kicks nor drifts
    std::vector<Leap> of_step{};
    long steps = 0;
    double velocity_unit = 1.0;

    // Whether what rounding takes from places and velocities is given back at the next leap (compensated
    // summation; Kahan: Further Remarks on Reducing Truncation Errors, Comm. ACM 8, 1965). Where the errors
    // of a method are that small, and where nothing is damped.
    bool compensated = false;
};
using LeapsOf = Leaps(const Rope& rope, const Stepping& stepping);

// Fields that a bundle needs for them.
int fields(const Leaps& leaps);

// Advances the ropes of a bundle, of that many fields, by all steps: one rope, or as many as these
// instructions have lanes. Adds to the cost what each rope costs.
void leap(const Leaps& leaps, Bundle& bundle, InstructionSet instructions, Cost& cost);

// The same for one rope.
void leap(const Leaps& leaps, const Rope& rope, State& state, Scratch& scratch);

// The `advance` of a method that is made of leaps.
template <LeapsOf leaps_of>
void advance_by(const Rope& rope, const Stepping& stepping, State& state, Scratch& scratch) {
    leap(leaps_of(rope, stepping), rope, state, scratch);
}

}  // namespace ropesim
