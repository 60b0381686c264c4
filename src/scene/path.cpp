#include "scene/path.h"

#include <cmath>
#include <cstddef>

namespace ropesim {
namespace {

std::vector<Eigen::Array2d> corners(const SceneRope& rope) {
    std::vector<Eigen::Array2d> result{rope.start};
    result.insert(result.end(), rope.via.begin(), rope.via.end());
    result.push_back(rope.end);
    return result;
}

double distance(const Eigen::Array2d& a, const Eigen::Array2d& b) {
    return std::sqrt((b - a).square().sum());
}

// The point that lies `before` of `whole` along the way from a to b.
Eigen::Array2d between(const Eigen::Array2d& a, const Eigen::Array2d& b, double before, double whole) {
    const Eigen::Array2d way = b - a;
    if (2.0 * before == whole) return (a + b) / 2.0;
    if (2.0 * before < whole) return a + way * before / whole;
    return b - way * (whole - before) / whole;
}

}  // namespace

double path_length(const SceneRope& rope) {
    const auto path = corners(rope);
    double length = 0.0;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) length += distance(path[i], path[i + 1]);
    return length;
}

Points points_along(const SceneRope& rope) {
    const auto path = corners(rope);
    const double length = path_length(rope);
    const double links = rope.nodes - 1;
    Points points(rope.nodes, 2);
    std::size_t corner = 0;  // the last one passed
    double passed = 0.0;     // the way to it
    double side = distance(path[0], path[1]);
    for (int i = 1; i + 1 < rope.nodes; ++i) {
        const double way = length * i / links;
        while (corner + 2 < path.size() && passed + side < way) {
            passed += side;
            ++corner;
            side = distance(path[corner], path[corner + 1]);
        }
        // Along a straight path both are counted in links: no rounding enters the shares.
        const double before = path.size() == 2 ? i : way - passed;
        const double whole = path.size() == 2 ? links : side;
        points.row(i) = between(path[corner], path[corner + 1], before, whole);
    }
    points.row(0) = rope.start;
    points.row(rope.nodes - 1) = rope.end;
    return points;
}

}  // namespace ropesim
