#include "simulation/links.h"
#include "simulation/methods/methods.h"

namespace ropesim {

// Verlet to the letter of the assignment, damping c as a share lost in each step:
//   x' = x + (1 - c) (x - x_prev) + h² a(x),   with x_prev = x at the start.
// That start is the velocity -h/2 a too low for rest, an error of order 1: undamped, the positions are those
// of symplectic Euler to rounding. The velocity here is (x - x_prev) / h; x - x_prev is what is computed
// with, for it loses no digits to where the rope is. Stable for h ω < 2.
Leaps seed_verlet(const Rope& rope, const Stepping& stepping) {
    const double h = stepping.step_size;
    Leaps leaps{.steps = stepping.steps, .velocity_unit = h};
    leaps.of_step.push_back({.before = velocity_kept(rope, stepping), .kick = h * h, .drift = 1.0});
    return leaps;
}

}  // namespace ropesim
