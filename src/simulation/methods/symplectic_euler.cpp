#include "simulation/links.h"
#include "simulation/methods/methods.h"

namespace ropesim {

// Symplectic (semi-implicit) Euler: kick, then drift with the new velocity. Order 1, symplectic.
//   v' = v + h a(x),   x' = x + h v'
// Stable for h ω < 2 (undamped). Hairer, Lubich, Wanner: Geometric Numerical Integration, 2006, I.1.
Leaps symplectic_euler(const Rope& rope, const Stepping& stepping) {
    const double h = stepping.step_size;
    Leaps leaps{.steps = stepping.steps};
    leaps.of_step.push_back({.before = velocity_kept(rope, stepping), .kick = h, .drift = h});
    return leaps;
}

// Trace 1 + kept - (h ω)², determinant kept: |trace| < 1 + determinant (Jury's criterion).
bool symplectic_euler_stable(double h_omega, double kept) {
    return h_omega * h_omega < 2.0 * (1.0 + kept);
}

}  // namespace ropesim
