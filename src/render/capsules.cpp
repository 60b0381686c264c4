#include "render/capsules.h"

#include "render/clip_segment.h"

#include <algorithm>
#include <cmath>

namespace ropesim {
namespace {

// Beyond its radius a capsule covers half a pixel; the rest is room for rounding.
constexpr double margin = 1.0;

// The part of the world that a picture shows, and how far a capsule outside may reach into it.
Box seen(const Camera& camera, int width, int height, double radius) {
    const double unit = camera.height / height;  // of the world, per pixel
    const Eigen::Array2d half = unit * (0.5 * Eigen::Array2d(width, height) + radius + margin);
    return {camera.center - half, camera.center + half};
}

std::array<float, 2> pixel(const Eigen::Array2d& point, const Camera& camera, int width, int height) {
    const Eigen::Array2d from_center = (point - camera.center) * (height / camera.height);
    return {static_cast<float>(0.5 * width + from_center.x()),
            static_cast<float>(0.5 * height - from_center.y())};
}

Eigen::Index finite_points(const Eigen::ArrayX2d& points) {
    Eigen::Index count = 0;
    while (count < points.rows() && points.row(count).isFinite().all()) ++count;
    return count;
}

}  // namespace

std::vector<Capsule> capsules(const Polyline& polyline, const Camera& camera, int width, int height) {
    std::vector<Capsule> capsules;
    const auto append = [&](Segment segment, double radius) {
        if (radius <= 0.0 || !clip(segment, seen(camera, width, height, radius))) return;
        capsules.push_back({pixel(segment.begin, camera, width, height),
                            pixel(segment.end, camera, width, height), static_cast<float>(radius)});
    };
    const Eigen::Index points = finite_points(polyline.points);
    for (Eigen::Index i = 0; i < points; ++i) {
        const Eigen::Array2d point = polyline.points.row(i);
        append({point, point}, 0.5 * polyline.point_size);
        if (i + 1 < points) append({point, polyline.points.row(i + 1)}, 0.5 * polyline.line_width);
    }
    return capsules;
}

PixelBox covered(const std::vector<Capsule>& capsules, int width, int height) {
    PixelBox box;
    for (const Capsule& capsule : capsules) {
        const double reach = capsule.radius + margin;
        const auto [left, right] = std::minmax(capsule.begin[0], capsule.end[0]);
        const auto [top, bottom] = std::minmax(capsule.begin[1], capsule.end[1]);
        box = united(
            box, {static_cast<int>(std::floor(left - reach)), static_cast<int>(std::floor(top - reach)),
                  static_cast<int>(std::ceil(right + reach)), static_cast<int>(std::ceil(bottom + reach))});
    }
    return intersection(box, {0, 0, width, height});
}

}  // namespace ropesim
