#include "sweep/point_cell.h"

#include "clip/picture.h"
#include "render/renderer.h"

#include <algorithm>
#include <string>

namespace ropesim {
namespace {

constexpr Color gray = {160, 160, 160};
constexpr Color orange = {230, 159, 0};

// Narrower pictures have no room for words.
constexpr int least_width_with_words = 200;

int cell_width(const Sweep& sweep) {
    constexpr int sheet_width = 2560;
    return std::clamp(sheet_width / static_cast<int>(sheet_columns(sweep)), 80, 320);
}

Words verdict(const PointResult& result) {
    if (!result.failure.empty()) return {"failed: " + result.failure, orange};
    if (result.diverged) return {"diverged in frame " + std::to_string(*result.diverged), orange};
    return {result.error ? "error " + to_string(*result.error) : "error unknown", gray};
}

}  // namespace

std::size_t sheet_columns(const Sweep& sweep) {
    constexpr std::size_t most_in_a_row = 8;
    const std::size_t last = sweep.variations.back().values.size();
    return sweep.variations.size() == 1 ? std::min(last, most_in_a_row) : last;
}

Image point_cell(const Sweep& sweep, long point, const Scene& scene, const std::vector<Points>& positions,
                 const PointResult& result) {
    const int width = cell_width(sweep);
    const int height = std::max(1, width * sweep.scene.size[1] / sweep.scene.size[0]);
    std::vector<Words> words;
    if (width >= least_width_with_words) {
        const std::vector<std::string> values = sweep.values(point);
        for (std::size_t i = 0; i < values.size(); ++i)
            words.push_back({sweep.variations[i].key + " = " + values[i], gray});
        words.push_back(verdict(result));
    }
    std::vector<Polyline> lines;
    if (!positions.empty()) lines = polylines(scene, positions);
    const double scale = static_cast<double>(width) / scene.size[0];
    for (Polyline& each : lines) {
        each.line_width = std::max(1.0, scale * each.line_width);
        each.point_size *= scale;
    }
    Renderer renderer(width, height, Camera{scene.view.center, scene.view.height}, scene.background, words);
    return renderer.draw(lines);
}

}  // namespace ropesim
