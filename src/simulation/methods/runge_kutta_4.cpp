#include "simulation/links.h"
#include "simulation/methods/methods.h"

#include <cmath>
#include <complex>

namespace ropesim {

// The classical Runge-Kutta method, on x' = v, v' = a(x) - damping v. Order 4, four evaluations a step; not
// symplectic: below its limit it loses energy, (h ω)^6/72 of a mode's in each step.
// Stable for h ω <= 2 sqrt(2) (undamped). Hairer, Nørsett, Wanner: Solving ODEs I, 1993, II.1.
void runge_kutta_4(const Rope& rope, const Stepping& stepping, State& state, Scratch& scratch) {
    const double h = stepping.step_size;
    const double damping = damping_per_step(rope, stepping) / h;
    constexpr double weights[4] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
    constexpr double nodes[4] = {0.5, 0.5, 1.0, 0.0};  // of the stage after this one
    Points& x = scratch.previous;
    Points& v = scratch.previous_velocity;
    Points& mean_velocity = scratch.displacement;
    Points& mean_acceleration = scratch.kick;
    for (long step = 0; step < stepping.steps; ++step) {
        x = state.position;
        v = state.velocity;
        mean_velocity.setZero(x.rows(), 2);
        mean_acceleration.setZero(x.rows(), 2);
        for (int stage = 0; stage < 4; ++stage) {
            accelerations(rope, state.position, scratch);
            scratch.acceleration -= damping * state.velocity;
            mean_velocity += weights[stage] * state.velocity;
            mean_acceleration += weights[stage] * scratch.acceleration;
            state.position = x + nodes[stage] * h * state.velocity;
            state.velocity = v + nodes[stage] * h * scratch.acceleration;
        }
        state.position = x + h * mean_velocity;
        state.velocity = v + h * mean_acceleration;
    }
}

// |1 + z + z²/2 + z³/6 + z⁴/24| <= 1 at both roots of z² + damping z + (h ω)² = 0.
bool runge_kutta_4_stable(double h_omega, double kept) {
    using Complex = std::complex<double>;
    const double damping = -std::log(kept);
    const Complex root = std::sqrt(Complex(damping * damping / 4.0 - h_omega * h_omega));
    for (const Complex z : {-damping / 2.0 + root, -damping / 2.0 - root})
        if (std::norm(1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0)))) > 1.0 + 1e-12)
            return false;
    return true;
}

}  // namespace ropesim
