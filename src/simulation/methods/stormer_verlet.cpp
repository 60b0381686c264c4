#include "simulation/links.h"
#include "simulation/methods/methods.h"

#include <cmath>

namespace ropesim {

// Störmer-Verlet in its velocity form: half a kick, drift, half a kick. Order 2, symplectic, symmetric.
//   v½ = v + h/2 a(x),   x' = x + h v½,   v' = v½ + h/2 a(x')
// Its positions are those of x'' = 2x' - x + h² a(x') started with x + h v + h²/2 a(x). Stable for h ω < 2.
// Hairer, Lubich, Wanner: Geometric Numerical Integration, 2006, I.1.4. Damping is exact on both sides of
// the step (Strang splitting), which leaves order and limit as they are.
Leaps stormer_verlet(const Rope& rope, const Stepping& stepping) {
    const double h = stepping.step_size;
    const double kept_half = std::sqrt(velocity_kept(rope, stepping));
    Leaps leaps{.opening = {.before = kept_half, .kick = h / 2.0, .drift = h}, .steps = stepping.steps};
    leaps.of_step.push_back({.kick = h / 2.0, .after = kept_half});
    return leaps;
}

// Trace (1 + kept) (1 - (h ω)²/2), determinant kept: damping does not move the limit.
bool stormer_verlet_stable(double h_omega, double /*kept*/) {
    return h_omega < 2.0;
}

}  // namespace ropesim
