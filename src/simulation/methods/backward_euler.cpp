#include "simulation/implicit_springs.h"
#include "simulation/links.h"
#include "simulation/methods/methods.h"

#include <limits>

namespace ropesim {

// Backward (implicit) Euler: the acceleration is that of the end of the step. Order 1; loses energy at any
// step, the more the stiffer; stable at every one.
//   v' = v + h a(x'),   x' = x + h v'
// Hairer, Lubich, Wanner: Geometric Numerical Integration, 2006, I.1. Solved for what the springs add,
// u = h² a_springs(x'), so that rounding is that of u and not of x'. Damping is exact before the step.
void backward_euler(const Rope& rope, const Stepping& stepping, State& state, Scratch& scratch) {
    const double h = stepping.step_size;
    const double kept = velocity_kept(rope, stepping);
    const Eigen::Index links = rope.start.rows() - 1;
    Points& moved = scratch.previous;
    for (long step = 0; step < stepping.steps; ++step) {
        state.velocity = kept * state.velocity + h * rope.free_fall;
        moved = h * state.velocity;
        scratch.springs.unsprung = (state.position.bottomRows(links) - state.position.topRows(links)) +
                                   (moved.bottomRows(links) - moved.topRows(links));
        if (!solve_implicit_springs(rope, h * h, scratch.springs, scratch.cost)) {
            state.position = std::numeric_limits<double>::quiet_NaN();
            return;
        }
        state.position += moved + scratch.springs.shift;
        state.velocity += scratch.springs.shift / h;
    }
}

}  // namespace ropesim
