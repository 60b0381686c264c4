#include "simulation/links.h"
#include "simulation/methods/methods.h"

#include <cmath>

namespace ropesim {

// Extended position-based dynamics: constraint projection whose links yield by their compliance 1/k. With
// λ the impulse that a link has got so far in this step, each link in turn, in each sweep, gets
//   Δλ = (-C - λ / (k h²)) / (w1 + w2 + 1 / (k h²)),   C = |d| - l,   w = 1/m
// Order 1 at any number of sweeps, which lead towards backward Euler; takes any step and any stiffness, for
// which it gives energy away. k -> infinity is constraint_projection.
// Macklin, Müller, Chentanez: XPBD, Motion in Games 2016, 3.5; many small steps instead of sweeps:
// Macklin et al.: Small Steps in Physics Simulation, SCA 2019.
void xpbd(const Rope& rope, const Stepping& stepping, State& state, Scratch& scratch) {
    const double h = stepping.step_size;
    const double kept = velocity_kept(rope, stepping);
    const double stiffness = rope.stiffness * h * h;
    const Eigen::Index links = state.position.rows() - 1;
    Points& moved = scratch.displacement;
    for (long step = 0; step < stepping.steps; ++step) {
        moved = h * (kept * state.velocity + h * rope.free_fall);
        scratch.multiplier.setZero(links);
        for (int sweep = 0; sweep < stepping.sweeps; ++sweep) {
            ++scratch.cost.solves;
            for (Eigen::Index link = 0; link < links; ++link) {
                const Eigen::Array2d d = link_after(state.position, moved, link);
                const double length = std::sqrt(d.x() * d.x() + d.y() * d.y());
                if (length == 0.0) continue;
                const double first = rope.inverse_mass(link);
                const double second = rope.inverse_mass(link + 1);
                double& impulse = scratch.multiplier(link);
                const double change = (-stiffness * (length - rope.rest_length) - impulse) /
                                      (stiffness * (first + second) + 1.0);
                impulse += change;
                moved.row(link) -= first * change / length * d.transpose();
                moved.row(link + 1) += second * change / length * d.transpose();
            }
        }
        state.position += moved;
        state.velocity = moved / h;
    }
}

}  // namespace ropesim
