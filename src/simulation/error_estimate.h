#pragma once

#include "simulation/simulate.h"

#include <memory>
#include <optional>
#include <string>

namespace ropesim {

// How far a run is from its model's solution, by two more runs.
struct ErrorEstimate {
    double error = 0.0;        // world units, greatest distance of any mass
    double uncertainty = 0.0;  // of it

    // Then the error is within a factor of two of this.
    bool trusted() const { return 2.0 * uncertainty <= error; }
};

// Two runs that tell how wrong a run of a method is. Most often they are nearer to the solution, by
// `blanes_moan_6` for springs and by `direct_projection` for links that keep their length, and cost less than
// half the method's own step would: the distance from the finer is the error, their distance from each other
// the uncertainty, also where the method's step is too large for its order to show. Only for
// `direct_projection` in many steps, which has nothing better beside it, they take two and four times its
// step: the error follows by its order, the uncertainty from how well the two distances show that order
// (Richardson's extrapolation; Hairer, Nørsett, Wanner: Solving ODEs I, 1993, II.4).
class ErrorEstimator {
  public:
    // The links of an inextensible rope must start at rest length.
    ErrorEstimator(const Rope& rope, const Method& method, const Stepping& stepping);

    // Both runs to the next frame.
    void advance();

    // Of a run that is in the same frame; none where one of the two could not get there.
    std::optional<ErrorEstimate> estimate(const Points& position) const;

    // "blanes_moan_6 at 8 and 6 steps per frame"
    std::string description() const;

    // Of a frame of both runs; one is an evaluation of the acceleration of a mass.
    double work() const;

  private:
    double rounding() const;

    std::unique_ptr<const Rope> rope_;  // with its damping as a rate
    const Method* solver_;
    bool extrapolates_;
    Stepping fine_stepping_;
    Stepping coarse_stepping_;
    MovingRope fine_;
    MovingRope coarse_;
    long frame_ = 0;
};

}  // namespace ropesim
