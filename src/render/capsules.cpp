#include "render/capsules.h"

#include "render/clip_segment.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

// Adds the tiles that a capsule may cover. In each row of tiles that is as far as the part of the segment
// goes from which a capsule reaches into the row.
void add_tiles(const Capsule& capsule, Tiles& tiles) {
    const double reach = capsule.radius + margin;
    auto [x, y] = capsule.begin;
    auto [end_x, end_y] = capsule.end;
    if (y > end_y) {
        std::swap(x, end_x);
        std::swap(y, end_y);
    }
    const double slope = end_y - y < 1.0F ? 0.0 : static_cast<double>(end_x - x) / (end_y - y);
    const auto row_of = [&](double at) {
        return static_cast<int>(std::clamp(at / tile_side, 0.0, tiles.rows() - 1.0));
    };
    const auto pixel_of = [&](double at) {
        return static_cast<int>(std::clamp(at, -1.0, 1.0 * tile_side * tiles.columns()));
    };
    const int last = row_of(end_y + reach);
    for (int row = row_of(y - reach); row <= last; ++row) {
        double left = x;
        double right = end_x;
        if (slope != 0.0) {
            const double top = std::clamp<double>(row * tile_side - reach, y, end_y);
            const double bottom = std::clamp<double>((row + 1) * tile_side + reach, y, end_y);
            left = x + slope * (top - y);
            right = x + slope * (bottom - y);
        }
        if (left > right) std::swap(left, right);
        tiles.add(
            {pixel_of(left - reach), row * tile_side, pixel_of(right + reach) + 1, row * tile_side + 1});
    }
}

// Up to which length, in pixels, a link lies within the mass that it begins at: there, its coverage is
// nowhere the greater one, and it need not be drawn.
double hidden_length(const Polyline& polyline) {
    constexpr double rounding = 1.0 / 16.0;  // more than coordinates in the shader are rounded by
    return 0.5 * (polyline.point_size - polyline.line_width) - rounding;
}

}  // namespace

void append_capsules(const Polyline& polyline, std::size_t channel, const Camera& camera, int width,
                     int height, std::vector<Capsule>& capsules, Tiles& covered) {
    const auto append = [&](Segment segment, double radius) {
        if (radius <= 0.0 || !clip(segment, seen(camera, width, height, radius))) return;
        Capsule capsule{pixel(segment.begin, camera, width, height),
                        pixel(segment.end, camera, width, height),
                        static_cast<float>(radius),
                        {}};
        capsule.channel[channel] = 255;
        capsules.push_back(capsule);
        add_tiles(capsule, covered);
    };
    const Eigen::Index points = finite_points(polyline.points);
    const double hidden = hidden_length(polyline) * camera.height / height;
    for (Eigen::Index i = 0; i < points; ++i) {
        const Eigen::Array2d point = polyline.points.row(i);
        append({point, point}, 0.5 * polyline.point_size);
        if (i + 1 == points) break;
        const Eigen::Array2d next = polyline.points.row(i + 1);
        if ((next - point).matrix().norm() > hidden) append({point, next}, 0.5 * polyline.line_width);
    }
}

}  // namespace ropesim
