#pragma once

#include "clip/positions.h"

#include <map>
#include <optional>
#include <string>

namespace ropesim {

// A mass that is not where it was expected.
struct Moved {
    long frame = 0;
    std::string rope;
    Eigen::Index mass = 0;
    double distance = 0.0;  // pixels of EXPECTED's picture
};

struct MotionDifference {
    std::map<long, double> distance;  // of every frame that both sides have: the farthest mass, in pixels
    std::optional<Moved> first;       // in the first frame where a bit differs, the farthest mass
    std::optional<Moved> farthest;
    std::vector<std::string> apart;  // ropes that cannot be compared: of other node counts, or only on one
                                     // side, or diverged on one
};

// "in frame 12, mass 3 of rope 'Euler', by 0.25 px"
std::string to_string(const Moved& moved);

// Ropes are matched by their names.
MotionDifference motion_difference(const Scene& expected_scene, const Positions& expected,
                                   const Scene& actual_scene, const Positions& actual);

}  // namespace ropesim
