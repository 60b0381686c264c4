#pragma once

#include "simulation/method.h"

#include <optional>

namespace ropesim {

// Mechanical energy in scene units: mass × (world unit per unit of time)².
struct Energy {
    double kinetic = 0.0;
    double spring = 0.0;   // zero for an inextensible rope
    double gravity = 0.0;  // zero at the origin

    double total() const { return kinetic + spring + gravity; }
};
Energy energy(const Rope& rope, Model model, const State& state);

// The greatest distance of a mass from where it should be, world units.
double greatest_distance(const Points& expected, const Points& actual);

// Greatest length of a link, world units.
double longest_link(const Points& position);

// Whether a link, or every link, has its rest length, to 1e-9 of it: what a rope must start with to move
// without springs.
bool is_rest_length(double rest_length, double length);
bool links_at_rest_length(const Rope& rope, const Points& position);

// Length along the rope, world units.
double rope_length(const Points& position);

// Tension of every link: force, negative where a spring is compressed or a rod pushes. For an inextensible
// rope it is what keeps |d| = l as the masses move: d·(a' - a) + |v' - v|² = 0 for each link, a tridiagonal
// system. Where that leaves it open (a rope straight between two pins) it is one of the answers.
Eigen::ArrayXd tensions(const Rope& rope, Model model, const State& state);

// What a rope is like in one frame.
struct Diagnostics {
    Energy energy;
    double largest_stretch = 0.0;  // greatest length of a link divided by the rest length, less 1
    double largest_tension = 0.0;  // force
    double length = 0.0;           // world units
};
Diagnostics diagnostics(const Rope& rope, Model model, const State& state);

// Greatest angular frequency that the springs of this rope can have in any state, radians per unit of
// time: that of the straight chain. The stiffness of a link is k (1 - l/L) across and k along it, at most k
// in either direction, and k is what the straight chain has along itself. By bisection with Sturm's
// sequence (Golub, Van Loan: Matrix Computations, 2013, 8.4.1); at most 2 sqrt(k / smallest mass).
double greatest_frequency(const Rope& rope);

// Whether the steps of this size are stable for the rope, to the linear theory.
bool stable(const Rope& rope, const Method& method, const Stepping& stepping);

// The fewest steps per frame that are stable; none where not even `most_steps` are.
inline constexpr long most_steps = 1'000'000;
std::optional<long> fewest_stable_steps(const Rope& rope, const Method& method, double frame_time,
                                        double damping_factor);

}  // namespace ropesim
