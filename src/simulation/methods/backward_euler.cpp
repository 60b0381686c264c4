#include "simulation/implicit_springs.h"
#include "simulation/links.h"
#include "simulation/methods/methods.h"

namespace ropesim {
namespace {

bool take_step(const Rope& rope, double h, double kept, State& state, Scratch& scratch) {
    Points& thrown = scratch.kick;
    Points& moved = scratch.previous;
    thrown = kept * state.velocity + h * rope.free_fall;
    moved = h * thrown;
    place_unsprung(state.position, moved, scratch.springs);
    if (!solve_implicit_springs(rope, h * h, scratch.springs, scratch.cost)) return false;
    state.position += moved + scratch.springs.shift;
    state.velocity = thrown + scratch.springs.shift / h;
    return true;
}

}  // namespace

// Backward (implicit) Euler: the acceleration is that of the end of the step. Order 1; loses energy at any
// step, the more the stiffer; stable at every one.
//   v' = v + h a(x'),   x' = x + h v'
// Hairer, Lubich, Wanner: Geometric Numerical Integration, 2006, I.1. Solved for what the springs add,
// u = h² a_springs(x'), so that rounding is that of u and not of x'. Damping is exact before the step.
void backward_euler(const Rope& rope, const Stepping& stepping, State& state, Scratch& scratch) {
    take_implicit_steps(take_step, rope, stepping, state, scratch);
}

}  // namespace ropesim
