#include "render/clip_segment.h"

#include <algorithm>
#include <numeric>

namespace ropesim {
namespace {

bool inside(const Eigen::Array2d& point, const Box& box) {
    return (point >= box.lowest).all() && (point <= box.highest).all();
}

// Both points lie beyond the same side of the box.
bool beyond_one_side(const Eigen::Array2d& a, const Eigen::Array2d& b, const Box& box) {
    return (a < box.lowest && b < box.lowest).any() || (a > box.highest && b > box.highest).any();
}

Eigen::Array2d midpoint(const Segment& segment) {
    return {std::midpoint(segment.begin.x(), segment.end.x()),
            std::midpoint(segment.begin.y(), segment.end.y())};
}

// A point of the segment inside the box; false where there is none. Halves the segment, keeping the half
// that may meet the box: a sum of far coordinates rounds by as little as its result is large, where a
// division by their difference would round by as much as they are.
bool find_inside(Segment segment, const Box& box, Eigen::Array2d& found) {
    for (const Eigen::Array2d& point : {segment.begin, segment.end}) {
        found = point;
        if (inside(found, box)) return true;
    }
    while (!beyond_one_side(segment.begin, segment.end, box)) {
        found = midpoint(segment);
        if (inside(found, box)) return true;
        if ((found == segment.begin).all() || (found == segment.end).all()) return false;
        (beyond_one_side(segment.begin, found, box) ? segment.begin : segment.end) = found;
    }
    return false;
}

// Where the way from a point inside the box to one outside leaves it.
Eigen::Array2d exit(const Eigen::Array2d& from, const Eigen::Array2d& to, const Box& box) {
    double part = 1.0;
    for (int axis = 0; axis < 2; ++axis) {
        const double way = to(axis) - from(axis);
        if (to(axis) > box.highest(axis)) part = std::min(part, (box.highest(axis) - from(axis)) / way);
        if (to(axis) < box.lowest(axis)) part = std::min(part, (box.lowest(axis) - from(axis)) / way);
    }
    return (from + part * (to - from)).max(box.lowest).min(box.highest);
}

}  // namespace

bool clip(Segment& segment, const Box& box) {
    Eigen::Array2d middle;
    if (!find_inside(segment, box, middle)) return false;
    if (!inside(segment.begin, box)) segment.begin = exit(middle, segment.begin, box);
    if (!inside(segment.end, box)) segment.end = exit(middle, segment.end, box);
    return true;
}

}  // namespace ropesim
