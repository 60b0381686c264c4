#include "simulation/simulate.h"

#include "simulation/diagnostics.h"

#include <algorithm>
#include <cmath>

namespace ropesim {
namespace {

bool has_diverged(const Rope& rope, const State& state) {
    return !state.position.isFinite().all() || !state.velocity.isFinite().all() ||
           longest_link(state.position) > sensible_length(rope, state.time);
}

}  // namespace

double sensible_length(const Rope& rope, double time) {
    const double links = static_cast<double>(rope.start.rows() - 1);
    const double fall = std::sqrt(rope.gravity.square().sum()) * time * time;
    return 1000.0 * (links * std::max(longest_link(rope.start), rope.rest_length) + fall);
}

Trajectory simulate(const Rope& rope, const Method& method, const Stepping& stepping, long frames) {
    State state = at_rest(rope);
    Scratch scratch;
    Trajectory trajectory;
    const double frame_time = static_cast<double>(stepping.steps) * stepping.step_size;
    const double first_energy = energy(rope, method.model, state).total();
    for (long frame = 0; frame < frames; ++frame) {
        if (frame > 0) method.advance(rope, stepping, state, scratch);
        state.time = static_cast<double>(frame) * frame_time;
        if (has_diverged(rope, state)) {
            trajectory.diverged = frame;
            break;
        }
        trajectory.largest_stretch =
            std::max(trajectory.largest_stretch, longest_link(state.position) / rope.rest_length - 1.0);
        trajectory.energy_drift = energy(rope, method.model, state).total() - first_energy;
        trajectory.frames.push_back(state.position);
    }
    return trajectory;
}

}  // namespace ropesim
