#include "simulation/error_estimate.h"

#include "simulation/diagnostics.h"
#include "simulation/links.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ropesim {
namespace {

// Of blanes_moan_6; a step of direct_projection costs about as much.
constexpr double evaluations_per_step = 14.0;

std::unique_ptr<const Rope> damped_by_rate(const Rope& rope, const Stepping& stepping) {
    Rope result = rope;
    result.damping = damping_per_step(rope, stepping) / stepping.step_size;
    return std::make_unique<const Rope>(std::move(result));
}

const Method& solver(Model model) {
    return find_method(model == Model::elastic ? "blanes_moan_6" : "direct_projection");
}

double frame_time(const Stepping& stepping) {
    return static_cast<double>(stepping.steps) * stepping.step_size;
}

// Whether the two runs are coarser than that of the method.
bool extrapolates(const Method& method, const Stepping& stepping) {
    constexpr long enough_for_a_quarter = 32;
    return &method == &solver(Model::inextensible) && stepping.steps >= enough_for_a_quarter;
}

// Steps per frame of the finer run. At h ω = 3, half its limit, blanes_moan_6 is a thousand times closer than
// Störmer-Verlet at h ω = 0.3 (the seed's rope); methods of higher order need it at steps nearer their own.
long fine_steps_elastic(const Rope& rope, const Method& method, const Stepping& stepping) {
    constexpr double fine_h_omega = 3.0;
    const double least = std::ceil(frame_time(stepping) * greatest_frequency(rope) / fine_h_omega);
    const long by_order = method.order == 1   ? 1
                          : method.order == 2 ? stepping.steps / 16
                          : method.order == 4 ? stepping.steps
                                              : 2 * stepping.steps;
    return std::max({4L, static_cast<long>(least), by_order});
}

// direct_projection of half the steps is hundreds of times closer than sweeps at 64.
long fine_steps_inextensible(const Method& method, const Stepping& stepping) {
    constexpr long least = 16;
    if (extrapolates(method, stepping)) return stepping.steps / 2;
    return method.order > 1 ? 4 * stepping.steps : std::max(least, stepping.steps / 2);
}

long fine_steps(const Rope& rope, const Method& method, const Stepping& stepping) {
    return method.model == Model::elastic ? fine_steps_elastic(rope, method, stepping)
                                          : fine_steps_inextensible(method, stepping);
}

// Three quarters of them: at order 6 the coarser run is off by six times as much; half at order 2: four
// times.
long coarse_steps(Model model, long fine) {
    return model == Model::elastic ? (3 * fine + 3) / 4 : fine / 2;
}

}  // namespace

ErrorEstimator::ErrorEstimator(const Rope& rope, const Method& method, const Stepping& stepping)
    : rope_(damped_by_rate(rope, stepping)),
      solver_(&solver(method.model)),
      extrapolates_(extrapolates(method, stepping)),
      fine_stepping_(ropesim::stepping(frame_time(stepping), fine_steps(rope, method, stepping))),
      coarse_stepping_(
          ropesim::stepping(frame_time(stepping), coarse_steps(method.model, fine_stepping_.steps))),
      fine_(*rope_, *solver_, fine_stepping_),
      coarse_(*rope_, *solver_, coarse_stepping_) {}

void ErrorEstimator::advance() {
    ++frame_;
    fine_.advance();
    coarse_.advance();
}

std::optional<ErrorEstimate> ErrorEstimator::estimate(const Points& position) const {
    if (fine_.diverged() || coarse_.diverged()) return std::nullopt;
    const double distance = greatest_distance(fine_.state().position, position);
    const double between = greatest_distance(fine_.state().position, coarse_.state().position);
    if (!extrapolates_) return ErrorEstimate{distance, between + rounding()};
    constexpr double two_to_the_order = 4.0;
    const double error = distance / (two_to_the_order - 1.0);
    return ErrorEstimate{error, std::abs(between / two_to_the_order - distance) + rounding()};
}

// As a random walk, with a rounding of the farthest coordinate in each evaluation of the finer run.
double ErrorEstimator::rounding() const {
    const double evaluations =
        evaluations_per_step * static_cast<double>(fine_stepping_.steps) * static_cast<double>(frame_);
    constexpr double magnified = 16.0;  // by the motion
    return magnified * std::numeric_limits<double>::epsilon() * fine_.state().position.abs().maxCoeff() *
           std::sqrt(evaluations);
}

std::string ErrorEstimator::description() const {
    return std::string(solver_->name) + " at " + std::to_string(fine_stepping_.steps) + " and " +
           std::to_string(coarse_stepping_.steps) + " steps per frame";
}

double ErrorEstimator::work() const {
    return evaluations_per_step * static_cast<double>(fine_stepping_.steps + coarse_stepping_.steps) *
           static_cast<double>(rope_->mass.size());
}

}  // namespace ropesim
