#include "simulation/links.h"
#include "simulation/methods/methods.h"

namespace ropesim {

// Infinitely stiff springs to the letter of the assignment: Verlet with gravity alone, then each link in
// turn, once, is pulled towards its rest length, every end that is not pinned moving by half the excess.
//   x* = x + (1 - c) (x - x_prev) + h² g,   x' = x* after one sweep
// Beside a pin half of the excess stays. The velocity here is (x - x_prev) / h; x - x_prev is what is
// computed with, for it loses no digits to where the rope is.
void seed_constraints(const Rope& rope, const Stepping& stepping, State& state, Scratch& scratch) {
    const double h = stepping.step_size;
    const double kept = velocity_kept(rope, stepping);
    const auto half_unless_pinned = [&](Eigen::Index mass) {
        return rope.inverse_mass(mass) > 0.0 ? 0.5 : 0.0;
    };
    Points& moved = scratch.displacement;
    moved = h * state.velocity;
    for (long step = 0; step < stepping.steps; ++step) {
        moved = kept * moved + h * h * rope.free_fall;
        ++scratch.cost.solves;
        for (Eigen::Index link = 0; link + 1 < state.position.rows(); ++link)
            pull_to_rest_length(state.position, moved, link, rope.rest_length, half_unless_pinned(link),
                                half_unless_pinned(link + 1));
        state.position += moved;
    }
    state.velocity = moved / h;
}

}  // namespace ropesim
