#pragma once

#include "simulation/bundle.h"
#include "simulation/implicit_springs.h"
#include "simulation/instruction_set.h"
#include "simulation/leaps.h"
#include "simulation/link_impulses.h"
#include "simulation/rope.h"

#include <compare>
#include <span>
#include <string>
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

    auto operator<=>(const Stepping&) const = default;
};

// The stepping that divides a frame into equal steps.
Stepping stepping(double frame_time, long steps_per_frame);

// What has been computed: the same on every machine, for a given rope, method and stepping.
struct Cost {
    long evaluations = 0;  // of the accelerations of all masses
    long solves = 0;       // of a linear system along the whole chain, or sweeps over all its links
};

// Working arrays of `direct_projection`.
struct DirectProjection {
    Eigen::ArrayXd weight;          // inverse masses; zero also where nothing can move
    Eigen::ArrayXd half;            // one per link: 1/2, or zero where both its masses are held
    Points before;                  // links×2, from mass i to mass i + 1 at the start of a step
    Points after;                   // links×2, at its end
    Eigen::ArrayXd lack;            // one per link: of a constraint; the change of impulse that mends it
    LinkSystem system;              // for them
    Eigen::ArrayXd impulse;         // one per link: of the step, h² tension / length
    Eigen::ArrayXd impulse_before;  // of the step before
};

// Working arrays. They carry nothing from one step to the next; they are kept to spare allocations.
struct Scratch {
    Points acceleration;
    Points link_force;  // masses + 1 rows
    Points previous;
    ImplicitSprings springs;
    DirectProjection direct_projection;
    Points displacement;
    Points kick;
    Eigen::ArrayXd multiplier;  // one per link
    Bundle bundle;
    InstructionSet instructions = widest_instruction_set();  // of the loops over masses
    Cost cost;                                               // adds up since the scratch was made
};

// Advances the state by `stepping.steps` steps, velocity included; state.time is left to the caller. A
// method that cannot solve a step (its iteration does not converge) fills the positions with NaN and
// returns, which `simulate` reports as divergence: there is no bad step that looks like a good one.
using Advance = void(const Rope& rope, const Stepping& stepping, State& state, Scratch& scratch);

// Whether a linear oscillator stays bounded: h ω is step times angular frequency, `kept` the share of its
// velocity that damping leaves after one step (1: undamped).
using Stable = bool(double h_omega, double kept);

// What a method keeps of an undamped rope's motion, at any stable step; all but the first to rounding.
struct Keeps {
    bool symplectic = false;        // the symplectic form, and so the energy within a band, without drift
    bool reversible = false;        // with its velocities negated, the rope goes back the way it came
    bool momentum = false;          // of a rope without pins
    bool angular_momentum = false;  // of a rope without pins or gravity
};

// A row of the table of methods.
struct Method {
    std::string_view name;
    Model model;
    int order;               // of the positions at a fixed time, undamped or damped by a rate
    double stability_limit;  // greatest stable h ω, undamped; 0: no step is stable; infinity: none is needed
    Stable* stable;          // null where every step is
    Keeps keeps;
    Advance* advance;
    LeapsOf* leaps;            // what it is made of; null where not of leaps
    std::string_view purpose;  // what it is for, one line
};

std::span<const Method> methods();

// The row of that name. Throws std::runtime_error that lists the known names.
const Method& find_method(std::string_view name);

std::string_view name(Model model);

// What is kept, a letter each: s(ymplectic), r(eversible), m(omentum), a(ngular momentum); "-" for nothing.
std::string letters(const Keeps& keeps);

}  // namespace ropesim
