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

double largest(const std::vector<Diagnostics>& frames, double Diagnostics::*member) {
    double result = frames.empty() ? 0.0 : frames.front().*member;
    for (const Diagnostics& frame : frames) result = std::max(result, frame.*member);
    return result;
}

}  // namespace

double Trajectory::largest_stretch() const {
    return largest(diagnostics, &Diagnostics::largest_stretch);
}

double Trajectory::largest_tension() const {
    return largest(diagnostics, &Diagnostics::largest_tension);
}

double Trajectory::energy_drift() const {
    return diagnostics.empty() ? 0.0 : diagnostics.back().energy.total() - diagnostics.front().energy.total();
}

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
    for (long frame = 0; frame < frames; ++frame) {
        if (frame > 0) method.advance(rope, stepping, state, scratch);
        state.time = static_cast<double>(frame) * frame_time;
        if (has_diverged(rope, state)) {
            trajectory.diverged = frame;
            break;
        }
        trajectory.diagnostics.push_back(diagnostics(rope, method.model, state));
        trajectory.frames.push_back(state.position);
    }
    trajectory.cost = scratch.cost;
    return trajectory;
}

}  // namespace ropesim
