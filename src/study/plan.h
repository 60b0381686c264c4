#pragma once

#include "study/method_error.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace ropesim {

// A method at a step, run over the whole clip.
struct Candidate {
    const Method* method = nullptr;
    long steps = 0;      // per frame
    double error = 0.0;  // pixels: worst of the believed frames; infinite where it did not reach them
    double work = 0.0;   // per frame; in evaluations of all accelerations
};

// The work of a run, in evaluations of all its accelerations: those, and solves or sweeps by what they cost
// beside an evaluation. Counted, not timed: the same on every machine, and so is what is chosen by it.
double work(const Rope& rope, const Method& method, const Cost& cost);

// What a rope needs to stay within a tolerance.
struct Plan {
    double tolerance = 0.0;              // pixels
    Truth truth;                         // of which the frames that are believed count
    std::vector<Candidate> tried;        // in the order of the trials
    std::optional<Candidate> choice;     // of least work within the tolerance; none where none keeps to it
    std::optional<Candidate> runner_up;  // of another method
    double growth = 0.0;  // how much farther than at the start a small disturbance is at the end
};

// Searches methods and steps for the least work whose error, over the problem's clip, is at most `tolerance`
// pixels. From each method's coarsest stable step on, always for the method that could still turn out
// cheapest, with the step that its order lets expect; then by bisection down to a tenth of the steps.
// All methods that fit the problem take part but the assignment's rules to the letter, for each of which
// there is a better row.
Plan plan(const Problem& problem, double tolerance);

// One run of the problem's clip.
Candidate candidate(const Problem& problem, const Truth& truth, const Method& method, long steps);

// Of the trials, those that no other beats in both work and error, from the least work on.
std::vector<Candidate> efficient(const Plan& plan);

// The rope with the chosen method and steps; its damping as a rate. Expects a choice.
SceneRope planned_rope(const SceneRope& rope, const Problem& problem, const Candidate& choice);

// The scene with every rope planned whose method is "auto"; others are as they were. Throws
// std::runtime_error where a tolerance cannot be kept, with what can.
Scene with_planned_ropes(const Scene& scene);

}  // namespace ropesim
