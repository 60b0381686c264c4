#include "simulation/links.h"
#include "simulation/methods/methods.h"

namespace ropesim {

// Constraint projection by Gauss-Seidel sweeps (position-based dynamics): fall freely, then set one link
// after the other back to its rest length, each end moving by its share of the inverse masses.
//   x* = x + h v + h² g,   x' = projection of x*,   v' = (x' - x) / h
// Order 1 against the inextensible rope; loses energy; stretches where a rope is long and sweeps are few.
// Müller, Heidelberger, Hennix, Ratcliff: Position Based Dynamics, J. Vis. Commun. Image R. 18, 2007, 3.3.
void constraint_projection(const Rope& rope, const Stepping& stepping, State& state, Scratch& scratch) {
    const double h = stepping.step_size;
    const double kept = velocity_kept(rope, stepping);
    Points& moved = scratch.displacement;  // x' - x, which unlike x' loses no digits to where the rope is
    for (long step = 0; step < stepping.steps; ++step) {
        moved = h * (kept * state.velocity + h * rope.free_fall);
        for (int sweep = 0; sweep < stepping.sweeps; ++sweep) {
            ++scratch.cost.solves;
            for (Eigen::Index link = 0; link + 1 < state.position.rows(); ++link) {
                const double first = rope.inverse_mass(link);
                const double both = first + rope.inverse_mass(link + 1);
                if (both == 0.0) continue;
                pull_to_rest_length(state.position, moved, link, rope.rest_length, first / both,
                                    1.0 - first / both);
            }
        }
        state.position += moved;
        state.velocity = moved / h;
    }
}

}  // namespace ropesim
