#pragma once

#include "simulation/rope.h"

#include <span>
#include <string_view>

namespace ropesim {

// What a rope obeys: springs of its stiffness, or links that keep their length (stiffness -> infinity).
enum class Model { elastic, inextensible };

// How a method goes from one frame to the next: equal steps, so that frames fall on steps.
struct Stepping {
    long steps = 64;              // per frame
    double step_size = 1.0 / 64;  // units of time
    double damping_factor = 0.0;  // share of its velocity that a mass loses in each step (the seed's damping)
    int sweeps = 1;               // over the links in each step, where a method sweeps
};

// The stepping that divides a frame into equal steps.
Stepping stepping(double frame_time, long steps_per_frame);

// Working arrays. They carry nothing from one step to the next; they are kept to spare allocations.
struct Scratch {
    Points acceleration;
    Points link_force;  // masses + 1 rows
    Points previous;
};

// Advances the state by `stepping.steps` steps, velocity included; state.time is left to the caller.
using Advance = void(const Rope& rope, const Stepping& stepping, State& state, Scratch& scratch);

// Whether a linear oscillator stays bounded: h ω is step times angular frequency, `kept` the share of its
// velocity that damping leaves after one step (1: undamped).
using Stable = bool(double h_omega, double kept);

// A row of the table of methods.
struct Method {
    std::string_view name;
    Model model;
    int order;               // of the positions at a fixed time, undamped or damped by a rate
    double stability_limit;  // greatest stable h ω, undamped; 0: no step is stable; infinity: none is needed
    Stable* stable;          // null where every step is
    Advance* advance;
    std::string_view purpose;  // what it is for, one line
};

std::span<const Method> methods();

// The row of that name. Throws std::runtime_error that lists the known names.
const Method& find_method(std::string_view name);

std::string_view name(Model model);

}  // namespace ropesim
