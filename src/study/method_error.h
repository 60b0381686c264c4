#pragma once

#include "scene/scene.h"
#include "simulation/simulate.h"
#include "study/reference.h"

#include <string_view>
#include <vector>

namespace ropesim {

// What a rope of a scene asks for, whichever way it is computed.
struct Problem {
    Rope rope;    // its damping is a rate; a factor per step, at the scene's own steps, has become one
    Model model;  // of the method that the scene names; springs where it names "auto"
    double frame_time = 1.0;
    long frames = 120;
    double pixels_per_unit = 1.0;
    long steps_per_frame = 64;  // that the scene names
    int sweeps = 1;             // where a method sweeps
};

// Throws std::runtime_error where the damping factor is 1, which is no rate.
Problem problem(const Scene& scene, const SceneRope& rope);

// Why a method of that model cannot move the problem's rope; "" where it can: it is the rope's model, or the
// rope has springs and the method none, and the links start at rest length (to 1e-9 of it), as those without
// springs must.
std::string obstacle(const Problem& problem, Model model);
bool fits(const Problem& problem, const Method& method);  // there is none

// The problem's equal steps.
Stepping stepping(const Problem& problem, long steps_per_frame);

// The problem's motion by a method.
Trajectory simulate(const Problem& problem, const Method& method, long steps_per_frame);

// The problem's solution, as far as it can be believed.
struct Truth {
    Reference reference;
    long frames = 0;     // that are believed, frame 0 included
    double error = 0.0;  // greatest of the believed frames, pixels
};

// The truth is believed up to this error, pixels; where a motion is chaotic it ends there.
inline constexpr double believed_error = 1e-3;

Truth truth(const Problem& problem);

// How far a trajectory is from the truth, pixels: greatest distance of any mass.
struct MethodError {
    std::vector<double> of_frame;  // of the frames that are both reached and believed
    double worst = 0.0;            // of the believed frames; infinite where not all of them are reached
    double last = 0.0;             // at the last believed frame; likewise
};
MethodError method_error(const Problem& problem, const Truth& truth, const std::vector<Points>& frames);

}  // namespace ropesim
