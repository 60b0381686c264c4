#include "simulation/simulate.h"

#include "simulation/diagnostics.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace ropesim {
namespace {

// A sum of zeros, unless there is an infinity or a NaN among them: many are asked at once.
bool is_finite(const State& state) {
    return (0.0 * state.position).sum() + (0.0 * state.velocity).sum() == 0.0;
}

// A sensible length of a rope that does not fall.
double sensible_length(const Rope& rope) {
    return static_cast<double>(rope.start.rows() - 1) * std::max(longest_link(rope.start), rope.rest_length);
}

double sensible_length(double length, const Rope& rope, double time) {
    return 1000.0 * (length + std::sqrt(rope.gravity.square().sum()) * time * time);
}

}  // namespace

MovingRope::MovingRope(const Rope& rope, const Method& method, const Stepping& stepping)
    : rope_(&rope),
      method_(&method),
      stepping_(stepping),
      sensible_length_(sensible_length(rope)),
      state_(at_rest(rope)) {
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
    if (has_diverged()) diverged_ = frame;
}

bool MovingRope::has_diverged() const {
    return !is_finite(state_) ||
           longest_link(state_.position) > sensible_length(sensible_length_, *rope_, state_.time);
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
    return sensible_length(sensible_length(rope), rope, time);
}

void check_kept(double masses, long frames) {
    if (masses * static_cast<double>(frames) <= most_kept) return;
    throw std::runtime_error("the positions of " + std::to_string(static_cast<long>(masses)) + " masses in " +
                             std::to_string(frames) +
                             " frames are to be kept in memory, expected fewer than 2^28 in all");
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
