#include "clip/picture.h"

#include <algorithm>
#include <string>

namespace ropesim {
namespace {

// Of ropes: more would be a column of text and not a legend.
constexpr std::size_t most_lines = 12;

// Black or white, whichever stands out (luma of ITU-R BT.601).
Color readable_on(const Color& background) {
    const int luma = 299 * background[0] + 587 * background[1] + 114 * background[2];
    return luma < 128 * 1000 ? Color{255, 255, 255} : Color{0, 0, 0};
}

// A rope with steps of its own says how many.
std::string name_and_steps(const SceneRope& rope) {
    if (!rope.steps_per_frame) return rope.name;
    return rope.name + " (" + std::to_string(*rope.steps_per_frame) + " steps per frame)";
}

std::vector<Words> words(const Scene& scene) {
    std::vector<Words> lines;
    if (!scene.words) return lines;
    const Color plain = readable_on(scene.background);
    if (!scene.title.empty()) lines.push_back({scene.title, plain});
    if (std::any_of(scene.ropes.begin(), scene.ropes.end(),
                    [](const SceneRope& rope) { return !rope.steps_per_frame; }))
        lines.push_back({"Steps per frame: " + std::to_string(scene.steps_per_frame), plain});
    const std::size_t ropes = scene.ropes.size();
    const std::size_t named = ropes <= most_lines ? ropes : most_lines - 1;  // so that more than one is left
    for (std::size_t i = 0; i < named; ++i)
        lines.push_back({name_and_steps(scene.ropes[i]), scene.ropes[i].color});
    if (named < ropes) lines.push_back({"and " + std::to_string(ropes - named) + " more ropes", plain});
    return lines;
}

}  // namespace

std::unique_ptr<Renderer> make_renderer(const Scene& scene) {
    return std::make_unique<Renderer>(scene.size[0], scene.size[1],
                                      Camera{scene.view.center, scene.view.height}, scene.background,
                                      words(scene));
}

std::vector<Polyline> polylines(const Scene& scene, const std::vector<Points>& positions) {
    std::vector<Polyline> lines;
    for (std::size_t i = 0; i < scene.ropes.size(); ++i) {
        const SceneRope& rope = scene.ropes[i];
        if (positions[i].rows() > 0)
            lines.push_back({positions[i], rope.color, rope.line_width, rope.point_size});
    }
    return lines;
}

}  // namespace ropesim
