#include "simulation/plain_methods.h"

#include "simulation/links.h"
#include "simulation/methods/blanes_moan_4.h"
#include "simulation/methods/blanes_moan_6.h"

#include <cmath>
#include <stdexcept>

namespace ropesim {

Points plain_accelerations(const Rope& rope, const Points& position) {
    const Eigen::Index masses = position.rows();
    Points force = Points::Zero(masses + 1, 2);  // of link i - 1 in row i
    for (Eigen::Index i = 0; i + 1 < masses; ++i) {
        const double dx = position(i + 1, 0) - position(i, 0);
        const double dy = position(i + 1, 1) - position(i, 1);
        const double length = std::sqrt(dx * dx + dy * dy + 1e-200);
        const double pull = rope.stiffness * (1.0 - rope.rest_length / length);
        force.row(i + 1) << pull * dx, pull * dy;
    }
    Points acceleration(masses, 2);
    for (Eigen::Index i = 0; i < masses; ++i)
        for (int axis = 0; axis < 2; ++axis)
            acceleration(i, axis) =
                rope.inverse_mass(i) * (force(i + 1, axis) - force(i, axis)) + rope.free_fall(i, axis);
    return acceleration;
}

namespace {

void symplectic_euler(const Rope& rope, const Stepping& stepping, State& state) {
    const double h = stepping.step_size;
    const double kept = velocity_kept(rope, stepping);
    for (long step = 0; step < stepping.steps; ++step) {
        state.velocity = kept * state.velocity + h * plain_accelerations(rope, state.position);
        state.position += h * state.velocity;
    }
}

void stormer_verlet(const Rope& rope, const Stepping& stepping, State& state) {
    const double h = stepping.step_size;
    const double kept_half = std::sqrt(velocity_kept(rope, stepping));
    for (long step = 0; step < stepping.steps; ++step) {
        state.velocity = kept_half * state.velocity + h / 2.0 * plain_accelerations(rope, state.position);
        state.position += h * state.velocity;
        state.velocity = kept_half * (state.velocity + h / 2.0 * plain_accelerations(rope, state.position));
    }
}

void seed_verlet(const Rope& rope, const Stepping& stepping, State& state) {
    const double h = stepping.step_size;
    const double kept = velocity_kept(rope, stepping);
    Points moved = h * state.velocity;
    for (long step = 0; step < stepping.steps; ++step) {
        moved = kept * moved + h * h * plain_accelerations(rope, state.position);
        state.position += moved;
    }
    state.velocity = moved / h;
}

void blanes_moan_4(const Rope& rope, const Stepping& stepping, State& state) {
    const double h = stepping.step_size;
    const double damping = damping_per_step(rope, stepping);
    for (long step = 0; step < stepping.steps; ++step) {
        state.velocity += BlanesMoan4::kicks[0] * h * plain_accelerations(rope, state.position);
        for (int i = 0; i < 6; ++i) {
            const double share = BlanesMoan4::drifts[i];
            state.position += share * h * mean_decay(share * damping) * state.velocity;
            state.velocity = decay(share * damping) * state.velocity +
                             BlanesMoan4::kicks[i + 1] * h * plain_accelerations(rope, state.position);
        }
    }
}

// A sum that is given back what rounding takes from it, where that is wanted.
void add(Points& sum, Points& lost, const Points& term, bool compensated) {
    const Points whole = compensated ? Points(term - lost) : term;
    const Points next = sum + whole;
    lost = (next - sum) - whole;
    sum = next;
}

void blanes_moan_6(const Rope& rope, const Stepping& stepping, State& state) {
    const double h = stepping.step_size;
    const double damping = damping_per_step(rope, stepping);
    const bool compensated = damping == 0.0;
    Points lost_position = Points::Zero(rope.start.rows(), 2);
    Points lost_velocity = lost_position;
    for (long step = 0; step < stepping.steps; ++step) {
        for (int i = 0; i < 15; ++i) {
            const double share = BlanesMoan6::drifts[i];
            add(state.position, lost_position, share * h * mean_decay(share * damping) * state.velocity,
                compensated);
            state.velocity *= decay(share * damping);
            if (i < 14)
                add(state.velocity, lost_velocity,
                    BlanesMoan6::kicks[i] * h * plain_accelerations(rope, state.position), compensated);
        }
    }
}

void runge_kutta_4(const Rope& rope, const Stepping& stepping, State& state) {
    const double h = stepping.step_size;
    const double damping = damping_per_step(rope, stepping) / h;
    constexpr double weights[4] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
    constexpr double nodes[4] = {0.5, 0.5, 1.0, 0.0};  // of the stage after this one
    for (long step = 0; step < stepping.steps; ++step) {
        const Points x = state.position;
        const Points v = state.velocity;
        Points mean_velocity = Points::Zero(x.rows(), 2);
        Points mean_acceleration = Points::Zero(x.rows(), 2);
        for (int stage = 0; stage < 4; ++stage) {
            Points acceleration = plain_accelerations(rope, state.position);
            acceleration -= damping * state.velocity;
            mean_velocity += weights[stage] * state.velocity;
            mean_acceleration += weights[stage] * acceleration;
            state.position = x + nodes[stage] * h * state.velocity;
            state.velocity = v + nodes[stage] * h * acceleration;
        }
        state.position = x + h * mean_velocity;
        state.velocity = v + h * mean_acceleration;
    }
}

}  // namespace

void advance_plainly(std::string_view method, const Rope& rope, const Stepping& stepping, State& state) {
    if (method == "symplectic_euler") return symplectic_euler(rope, stepping, state);
    if (method == "stormer_verlet") return stormer_verlet(rope, stepping, state);
    if (method == "seed_verlet") return seed_verlet(rope, stepping, state);
    if (method == "blanes_moan_4") return blanes_moan_4(rope, stepping, state);
    if (method == "blanes_moan_6") return blanes_moan_6(rope, stepping, state);
    if (method == "runge_kutta_4") return runge_kutta_4(rope, stepping, state);
    throw std::runtime_error("no plain form of " + std::string(method));
}

}  // namespace ropesim
