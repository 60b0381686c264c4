#include "simulation/implicit_springs.h"
#include "simulation/links.h"
#include "simulation/methods/methods.h"

#include <cmath>
#include <limits>

namespace ropesim {

// Implicit midpoint: the acceleration is that of the middle of the step. Order 2, symplectic, symmetric,
// keeps every quadratic invariant; stable at every step.
//   m = x + h/2 v + h²/4 a(m),   x' = 2m - x,   v' = v + h a(m)
// Hairer, Lubich, Wanner: Geometric Numerical Integration, 2006, I.1, IV.2.1. Solved for what the springs
// add, u = h²/4 a_springs(m), so that rounding is that of u and not of m. Damping is exact on both sides of
// the step (Strang splitting), which leaves the order as it is.
void implicit_midpoint(const Rope& rope, const Stepping& stepping, State& state, Scratch& scratch) {
    const double h = stepping.step_size;
    const double kept_half = std::sqrt(velocity_kept(rope, stepping));
    const Eigen::Index links = rope.start.rows() - 1;
    Points& moved = scratch.previous;
    for (long step = 0; step < stepping.steps; ++step) {
        state.velocity *= kept_half;
        moved = h / 2.0 * (state.velocity + h / 2.0 * rope.free_fall);
        scratch.springs.unsprung = (state.position.bottomRows(links) - state.position.topRows(links)) +
                                   (moved.bottomRows(links) - moved.topRows(links));
        if (!solve_implicit_springs(rope, h * h / 4.0, scratch.springs, scratch.cost)) {
            state.position = std::numeric_limits<double>::quiet_NaN();
            return;
        }
        state.position += 2.0 * (moved + scratch.springs.shift);
        state.velocity =
            kept_half * (state.velocity + (h * rope.free_fall + 4.0 / h * scratch.springs.shift));
    }
}

}  // namespace ropesim
