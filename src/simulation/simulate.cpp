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

MovingRope::MovingRope(const Rope& rope, const Method& method, const Stepping& stepping)
    : rope_(&rope), method_(&method), stepping_(stepping), state_(at_rest(rope)) {
    enter(0);
}

void MovingRope::advance() {
    if (diverged_) return;
    method_->advance(*rope_, stepping_, state_, scratch_);
    enter(frame_ + 1);
}

void MovingRope::advance(const Bundle& bundle, Eigen::Index lane, const Leaps& leaps, const Cost& cost) {
    if (diverged_) return;
    bundle.take(state_, lane, leaps.velocity_unit);
    scratch_.cost.evaluations += cost.evaluations;
    enter(frame_ + 1);
}

void MovingRope::enter(long frame) {
    frame_ = frame;
    state_.time = static_cast<double>(frame) * (static_cast<double>(stepping_.steps) * stepping_.step_size);
    if (has_diverged(*rope_, state_)) diverged_ = frame;
}

Diagnostics MovingRope::diagnostics() const {
    return ropesim::diagnostics(*rope_, method_->model, state_);
}

void Summary::add(const Diagnostics& frame) {
    const bool first = !first_energy;
    if (first) first_energy = frame.energy;
    largest_stretch = first ? frame.largest_stretch : std::max(largest_stretch, frame.largest_stretch);
    largest_tension = first ? frame.largest_tension : std::max(largest_tension, frame.largest_tension);
    last_energy = frame.energy;
}

double sensible_length(const Rope& rope, double time) {
    const double links = static_cast<double>(rope.start.rows() - 1);
    const double fall = std::sqrt(rope.gravity.square().sum()) * time * time;
    return 1000.0 * (links * std::max(longest_link(rope.start), rope.rest_length) + fall);
}

Trajectory simulate(const Rope& rope, const Method& method, const Stepping& stepping, long frames) {
    MovingRope moving(rope, method, stepping);
    Trajectory trajectory;
    for (long frame = 0; frame < frames; ++frame) {
        if (frame > 0) moving.advance();
        if (moving.diverged()) break;
        trajectory.summary.add(moving.diagnostics());
        trajectory.frames.push_back(moving.state().position);
    }
    trajectory.diverged = moving.diverged();
    trajectory.cost = moving.cost();
    return trajectory;
}

}  // namespace ropesim
