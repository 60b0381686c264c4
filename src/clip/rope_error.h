#pragma once

#include "simulation/error_estimate.h"

#include <optional>
#include <string>
#include <vector>

namespace ropesim {

// What is known of how wrong a rope is on the picture, frame by frame from frame 0 on. Pixels.
class RopeError {
  public:
    // Looks at the estimator's runs, not at where the rope is, which `add` is given.
    RopeError(const Rope& rope, const Method& method, const Stepping& stepping, double pixels_per_unit);

    // The next frame of the rope, from frame 1 on.
    void add(const Points& position);

    // The estimate of a frame is a number or, where it cannot be trusted, none; of the first
    // `most_frames_kept` frames.
    static constexpr std::size_t most_frames_kept = 100'000;
    const std::vector<std::optional<float>>& frames() const { return frames_; }

    // Greatest error: about, or more or less than this.
    enum class Bound { about, more_than, less_than };
    struct Worst {
        Bound bound = Bound::about;
        double pixels = 0.0;
        long frame = 0;
    };
    Worst worst() const;

    // In the last frame, where it can be trusted.
    std::optional<double> last() const { return last_; }

    // What stands in for the solution, as ErrorEstimator says it.
    std::string description() const { return estimator_.description(); }
    double work() const { return estimator_.work(); }

  private:
    ErrorEstimator estimator_;
    double pixels_per_unit_;
    long frame_ = 0;
    std::vector<std::optional<float>> frames_{0.0F};
    std::optional<double> last_ = 0.0;
    double least_ = 0.0;  // that the greatest error is
    double most_ = 0.0;   // that it can be
    long least_frame_ = 0;
};

// "0.2 px"
std::string pixels(double number);

// "0.2 px", "more than 12 px"
std::string to_string(const RopeError::Worst& worst);

}  // namespace ropesim
