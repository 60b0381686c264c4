#include "simulation/implicit_springs.h"
#include "simulation/links.h"
#include "simulation/methods/methods.h"

#include <cmath>

namespace ropesim {
namespace {

bool take_step(const Rope& rope, double h, double kept, State& state, Scratch& scratch) {
    const double kept_half = std::sqrt(kept);
    Points& thrown = scratch.kick;
    Points& moved = scratch.previous;
    thrown = kept_half * state.velocity;
    moved = h / 2.0 * (thrown + h / 2.0 * rope.free_fall);
    place_unsprung(state.position, moved, scratch.springs);
    if (!solve_implicit_springs(rope, h * h / 4.0, scratch.springs, scratch.cost)) return false;
    state.position += 2.0 * (moved + scratch.springs.shift);
    state.velocity = kept_half * (thrown + (h * rope.free_fall + 4.0 / h * scratch.springs.shift));
    return true;
}

}  // namespace

// Implicit midpoint: the acceleration is that of the middle of the step. Order 2, symplectic, symmetric,
// keeps every quadratic invariant; stable at every step.
//   m = x + h/2 v + h²/4 a(m),   x' = 2m - x,   v' = v + h a(m)
// Hairer, Lubich, Wanner: Geometric Numerical Integration, 2006, I.1, IV.2.1. Solved for what the springs
// add, u = h²/4 a_springs(m), so that rounding is that of u and not of m. Damping is exact on both sides of
// the step (Strang splitting), which leaves the order as it is.
void implicit_midpoint(const Rope& rope, const Stepping& stepping, State& state, Scratch& scratch) {
    take_implicit_steps(take_step, rope, stepping, state, scratch);
}

}  // namespace ropesim
