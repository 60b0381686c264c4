#include "compare/comparison_painter.h"

#include "clip/picture.h"
#include "clip/rope_error.h"
#include "compare/compared_scene.h"
#include "image/difference.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ropesim {
namespace {

constexpr Color gray = {150, 150, 150};
constexpr Color black = {0, 0, 0};

// As in difference_picture.
constexpr Color only_expected = {255, 0, 0};
constexpr Color only_actual = {0, 255, 0};

Renderer rope_renderer(const Scene& scene) {
    return {scene.size[0], scene.size[1], Camera{scene.view.center, scene.view.height}, scene.background, {}};
}

// Lines between the same masses of two runs where they are more than a pixel apart.
void add_distances(const Points& first, const Points& run, double pixels_per_unit,
                   std::vector<Polyline>& lines) {
    if (first.rows() == 0 || run.rows() == 0) return;
    for (Eigen::Index i = 0; i < run.rows(); ++i) {
        Points ends(2, 2);
        ends << first.row(i), run.row(i);
        const double apart = std::hypot(ends(1, 0) - ends(0, 0), ends(1, 1) - ends(0, 1));
        if (apart * pixels_per_unit > 1.0) lines.push_back({ends, gray, 1.0, 0.0});
    }
}

std::vector<Polyline> overlay(const Scene& scene, const std::vector<Points>& positions) {
    std::vector<Polyline> lines;
    const double pixels_per_unit = scene.size[1] / scene.view.height;
    for (std::size_t i = 1; i < positions.size(); ++i)
        add_distances(positions.front(), positions[i], pixels_per_unit, lines);
    std::vector<Polyline> ropes = polylines(scene, positions);
    std::ranges::move(ropes, std::back_inserter(lines));
    return lines;
}

// Puts what `words` shows on its background over the picture's top left.
void lay_over(const Image& words, Color background, Image& picture) {
    for (int y = 0; y < std::min(words.height, picture.height); ++y)
        for (int x = 0; x < std::min(words.width, picture.width); ++x)
            if (const Color color = pixel(words, x, y); color != background) set_pixel(picture, x, y, color);
}

// As square as may be; up to three in a row.
Image arranged(const std::vector<Image>& panels, Color line) {
    constexpr int gap = 2;  // pixels
    const auto count = static_cast<int>(panels.size());
    const int columns = count <= 3 ? count : static_cast<int>(std::ceil(std::sqrt(count)));
    const int rows = (count + columns - 1) / columns;
    const int width = panels.front().width;
    const int height = panels.front().height;
    Image all = filled(columns * (width + gap) - gap, rows * (height + gap) - gap, line);
    for (int i = 0; i < count; ++i)
        paste(panels[static_cast<std::size_t>(i)], all, i % columns * (width + gap),
              i / columns * (height + gap));
    return all;
}

struct GraphBox {
    double left, bottom, width, height;
};

// A curve in the box, of numbers from 0 to `top` over all frames, up to and with `frame`, about one point for
// each of its pixels at most. Where a run has diverged it ends.
Polyline curve(const Parting& parting, std::size_t run, long frame, const GraphBox& box, double top,
               Color color) {
    const auto frames = static_cast<long>(parting.frames.size());
    const long stride = std::max(1L, std::lround(std::ceil(static_cast<double>(frames) / box.width)));
    const double step = box.width / static_cast<double>(std::max(1L, frames - 1));
    Polyline line{Points(frame / stride + 2, 2), color, 1.5, 0.0};
    Eigen::Index count = 0;
    for (long f = 0; f <= frame; f = f < frame ? std::min(f + stride, frame) : frame + 1) {
        const auto& apart = parting.frames[static_cast<std::size_t>(f)][run].apart;
        if (!apart) break;
        line.points.row(count++) << box.left + step * static_cast<double>(f),
            box.bottom + box.height * std::min(1.0, apart->greatest / top);
    }
    line.points.conservativeResize(count, 2);
    return line;
}

// The colour as words can be read in it: half way to white or black where it is about as dark as the
// background (luma of ITU-R BT.601).
Color legible(const Color& color, const Color& background) {
    const auto luma = [](const Color& c) { return (299 * c[0] + 587 * c[1] + 114 * c[2]) / 1000; };
    if (std::abs(luma(color) - luma(background)) >= 80) return color;
    const int towards = luma(background) < 128 ? 255 : 0;
    Color mixed;
    for (std::size_t i = 0; i < mixed.size(); ++i)
        mixed[i] = static_cast<std::uint8_t>((color[i] + towards) / 2);
    return mixed;
}

Polyline axes(const GraphBox& box) {
    Polyline line{Points(3, 2), gray, 1.0, 0.0};
    line.points << box.left, box.bottom + box.height, box.left, box.bottom, box.left + box.width, box.bottom;
    return line;
}

}  // namespace

// A run that blows up must not flatten the others: beyond the picture's height is far enough.
ComparisonPainter::ComparisonPainter(const Scene& scene, const Parting& parting, Layout layout)
    : scene_(scene), parting_(parting), layout_(layout), scale_(1e-9), renderer_(rope_renderer(scene)) {
    for (const ComparedFrame& run : parting.frames.back()) scale_ = std::max(scale_, run.farthest);
    scale_ = std::min(scale_, static_cast<double>(scene.size[1]));
}

std::string ComparisonPainter::distance_up_to(std::size_t run, long frame) const {
    const auto& diverged = parting_.diverged[run];
    if (diverged && *diverged <= frame) return ", diverged in frame " + std::to_string(*diverged);
    if (run == 0) return "";
    return ": up to " + pixels(parting_.frames[static_cast<std::size_t>(frame)][run].farthest) + " apart";
}

// What a run is drawn in.
Color ComparisonPainter::color(std::size_t run) const {
    if (layout_ != Layout::difference) return scene_.ropes[run].color;
    return run == 0 ? only_expected : only_actual;
}

Image ComparisonPainter::corner(long frame, std::span<const std::size_t> runs) const {
    const Color background = layout_ == Layout::difference ? black : scene_.background;
    std::vector<Words> words;
    if (!scene_.title.empty()) words.push_back({scene_.title, gray});
    for (const std::size_t run : runs)
        words.push_back(
            {label(scene_, scene_.ropes[run]) + distance_up_to(run, frame), legible(color(run), background)});
    const bool with_graph = runs.back() > 0;
    words.push_back({"frame " + std::to_string(frame) +
                         (with_graph ? "; graph: distance over time, up to " + pixels(scale_) : ""),
                     gray});
    const int width = scene_.size[0];
    const int height = std::min(scene_.size[1], 24 * static_cast<int>(words.size()) + 40);
    const double side = std::min(240.0, width / 4.0);
    const GraphBox box{width - side - 12.0, height - 12.0 - side / 3.0, side, side / 3.0};
    std::vector<Polyline> graph;
    if (with_graph) graph.push_back(axes(box));
    for (const std::size_t run : runs)
        if (run > 0) graph.push_back(curve(parting_, run, frame, box, scale_, color(run)));
    Renderer renderer(width, height, Camera{{width / 2.0, height / 2.0}, static_cast<double>(height)},
                      background, scene_.words ? std::span<const Words>(words) : std::span<const Words>());
    return renderer.draw(graph);
}

Image ComparisonPainter::panel(long frame, const std::vector<Points>& positions, std::size_t run) {
    std::vector<Points> alone(positions.size());
    alone[run] = positions[run];
    Image picture = renderer_.draw(polylines(scene_, alone));
    if (layout_ == Layout::difference) {
        alone[run].resize(0, 2);
        alone[0] = positions[0];
        picture = difference_picture(renderer_.draw(polylines(scene_, alone)), picture);
    }
    const std::vector<std::size_t> runs =
        layout_ == Layout::difference ? std::vector<std::size_t>{0, run} : std::vector<std::size_t>{run};
    lay_over(corner(frame, runs), layout_ == Layout::difference ? black : scene_.background, picture);
    return picture;
}

Image ComparisonPainter::draw(long frame, const std::vector<Points>& positions) {
    if (layout_ == Layout::overlay) {
        std::vector<std::size_t> all(positions.size());
        std::iota(all.begin(), all.end(), std::size_t{0});
        Image picture = renderer_.draw(overlay(scene_, positions));
        lay_over(corner(frame, all), scene_.background, picture);
        return picture;
    }
    std::vector<Image> panels;
    for (std::size_t run = layout_ == Layout::difference ? 1 : 0; run < positions.size(); ++run)
        panels.push_back(panel(frame, positions, run));
    return arranged(panels, gray);
}

Image strip(const Scene& scene, const Parting& parting, const std::vector<long>& frames,
            const std::vector<std::vector<Points>>& positions) {
    constexpr double cell_width = 480.0;  // pixels
    Scene small = scene;
    const double ratio = std::min(1.0, cell_width / scene.size[0]);
    for (int& side : small.size) side = static_cast<int>(std::lround(ratio * side));
    for (SceneRope& rope : small.ropes) {
        rope.line_width *= ratio;
        rope.point_size *= ratio;
    }
    std::vector<Image> cells;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        std::vector<Words> words{{"frame " + std::to_string(frames[i]), gray}};
        for (std::size_t run = 0; run < scene.ropes.size(); ++run) {
            const auto& apart = parting.frames[static_cast<std::size_t>(frames[i])][run].apart;
            const std::string distance = run == 0 ? ""
                                         : apart  ? ": " + pixels(apart->greatest) + " apart"
                                                  : ": diverged";
            words.push_back(
                {scene.ropes[run].name + distance, legible(scene.ropes[run].color, scene.background)});
        }
        Renderer renderer(small.size[0], small.size[1], Camera{scene.view.center, scene.view.height},
                          scene.background, words);
        cells.push_back(renderer.draw(overlay(small, positions[i])));
    }
    return arranged(cells, gray);
}

}  // namespace ropesim
