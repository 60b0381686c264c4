#include "simulation/links.h"
#include "simulation/methods/methods.h"

namespace ropesim {

// Explicit (forward) Euler: drift and kick, both from the old state. Order 1.
//   x' = x + h v,   v' = v + h a(x)
// Its determinant is 1 + (h ω)^2: undamped, no step is stable.
// Hairer, Lubich, Wanner: Geometric Numerical Integration, 2006, I.1.
void explicit_euler(const Rope& rope, const Stepping& stepping, State& state, Scratch& scratch) {
    const double h = stepping.step_size;
    const double kept = velocity_kept(rope, stepping);
    for (long step = 0; step < stepping.steps; ++step) {
        accelerations(rope, state.position, scratch);
        state.position += h * state.velocity;
        state.velocity = kept * state.velocity + h * scratch.acceleration;
    }
}

// The matrix (1, h; -h ω², kept) has determinant kept + (h ω)².
bool explicit_euler_stable(double h_omega, double kept) {
    return h_omega * h_omega < 1.0 - kept;
}

}  // namespace ropesim
