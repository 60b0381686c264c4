#pragma once

#include "clip/simulation.h"
#include "sweep/sweep.h"

#include <optional>
#include <string>
#include <string_view>

namespace ropesim {

// What a scene's ropes came to, as numbers that are the same on every machine.
struct PointResult {
    std::optional<RopeError::Worst> error;  // of the rope that is farthest off; none where unknown
    double work = 0.0;                      // evaluations of the acceleration of one mass, per frame
    double largest_stretch = 0.0;
    double energy_drift = 0.0;     // of the rope whose energy drifts farthest; scene units
    std::optional<long> diverged;  // the first frame that a rope did not reach
    std::string failure;           // why there is no motion; "" where there is
};

// Of a simulation that has come to its last frame.
PointResult point_result(const Simulation& simulation);

// The header and one line of the sweep's CSV: point, the varied keys, error_px, error_bound ("about",
// "more than", "less than"), work, largest_stretch, energy_drift, diverged_at, status ("ok", "diverged",
// "failed") and why it failed. What is not known is empty.
std::string sweep_csv_header(const Sweep& sweep);
std::string csv_line(const Sweep& sweep, long point, const PointResult& result);

// What such a line says; none where it is not the line of that point.
std::optional<PointResult> parse_csv_line(const Sweep& sweep, long point, std::string_view line);

}  // namespace ropesim
