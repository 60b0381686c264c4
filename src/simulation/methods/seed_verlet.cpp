#include "simulation/links.h"
#include "simulation/methods/methods.h"

namespace ropesim {

// Verlet to the letter of the assignment, damping c as a share lost in each step:
//   x' = x + (1 - c) (x - x_prev) + h² a(x),   with x_prev = x at the start.
// That start is the velocity -h/2 a too low for rest, an error of order 1: undamped, the positions are those
// of symplectic Euler to rounding. The velocity here is (x - x_prev) / h; x - x_prev is what is computed
// with, for it loses no digits to where the rope is. Stable for h ω < 2.
void seed_verlet(const Rope& rope, const Stepping& stepping, State& state, Scratch& scratch) {
    const double h = stepping.step_size;
    const double kept = velocity_kept(rope, stepping);
    Points& moved = scratch.displacement;
    moved = h * state.velocity;
    for (long step = 0; step < stepping.steps; ++step) {
        accelerations(rope, state.position, scratch);
        moved = kept * moved + h * h * scratch.acceleration;
        state.position += moved;
    }
    state.velocity = moved / h;
}

}  // namespace ropesim
