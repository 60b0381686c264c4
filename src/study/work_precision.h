#pragma once

#include "study/contender.h"
#include "study/timing.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace ropesim {

// One run of a contender over the clip.
struct Measurement {
    double setting = 0.0;  // steps per frame or tolerance
    double h_omega = 0.0;  // step times the rope's greatest frequency; 0 where steps adapt
    bool stable = true;    // to linear theory
    long frames = 0;       // that it reached, frame 0 included
    double worst = 0.0;    // pixels, over the believed frames; infinite where it did not reach them
    double last = 0.0;     // pixels, at the last believed frame; likewise
    Cost cost;             // of all frames, the one that it failed in included
    Times time;            // per frame
};

// A contender over the range of its settings, from the coarsest on.
struct Curve {
    Contender contender;
    std::vector<Measurement> measurements;
};

struct WorkPrecision {
    Problem problem;
    Truth truth;
    std::vector<Curve> curves;
};

// Those named; or, of our methods and of what else one would take, all that can move the problem's rope.
// Throws std::runtime_error for a name that is unknown, and for one that cannot.
std::vector<Contender> contenders(const Problem& problem, const std::vector<std::string>& names);

// The settings of a contender, from where it fails to where rounding or the model sets the floor, or to
// where it costs too much: runs it at each, without times. The same on every call, to the last bit.
Curve errors_of(const Contender& contender, const Problem& problem, const Truth& truth);

// How far a study has come: turns done and all turns, which are known only once the errors are.
using Report = std::function<void(std::string_view doing, long done, long all)>;

// Errors and times of all contenders.
WorkPrecision work_precision(const Problem& problem, const std::vector<Contender>& contenders,
                             const Report& report);

// The fastest run among curves of ours (or of others) whose error is at most `pixels`, and that of every
// finer run of its curve too: a small error beside larger ones is luck. Null where there is none.
struct Cheapest {
    const Curve* curve = nullptr;
    const Measurement* measurement = nullptr;
};
Cheapest cheapest(const WorkPrecision& study, bool ours, double pixels);

}  // namespace ropesim
