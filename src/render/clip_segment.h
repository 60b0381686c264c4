#pragma once

#include <Eigen/Core>

namespace ropesim {

// A rectangle, sides parallel to the axes.
struct Box {
    Eigen::Array2d lowest;
    Eigen::Array2d highest;
};

// A straight line between two points.
struct Segment {
    Eigen::Array2d begin;
    Eigen::Array2d end;
};

// Cuts the segment to its part inside the box; false where there is none. Coordinates may be any finite
// numbers, however large: what is kept lies in the box. A segment inside the box keeps its bits.
bool clip(Segment& segment, const Box& box);

}  // namespace ropesim
