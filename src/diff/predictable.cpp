#include "diff/predictable.h"

#include "clip/run.h"

#include "simulation/diagnostics.h"

#include <cmath>
#include <limits>

namespace ropesim {
namespace {

constexpr double visible = 1e-6;  // pixels

// One mass of the rope that is not pinned, a rounding away; the same where all are.
Rope disturbed(Rope rope) {
    for (Eigen::Index i = rope.start.rows() - 1; i >= 0; --i) {
        if (rope.inverse_mass(i) == 0.0) continue;
        for (int axis = 0; axis < 2; ++axis)
            rope.start(i, axis) =
                std::nextafter(rope.start(i, axis), std::numeric_limits<double>::infinity());
        break;
    }
    return rope;
}

}  // namespace

std::optional<long> first_unpredictable_frame(const Scene& scene) {
    const double pixels_per_unit = scene.size[1] / scene.view.height;
    std::vector<Run> of_others = runs(scene);
    for (Run& run : of_others) run.rope = disturbed(run.rope);
    const std::vector<Trajectory> motions = simulate(scene, runs(scene));
    const std::vector<Trajectory> others = simulate(scene, of_others);
    for (long frame = 0; frame < scene.frames; ++frame) {
        for (std::size_t i = 0; i < motions.size(); ++i) {
            const auto at = static_cast<std::size_t>(frame);
            if (at >= motions[i].frames.size() && at >= others[i].frames.size()) continue;
            if (at >= motions[i].frames.size() || at >= others[i].frames.size()) return frame;
            if (greatest_distance(motions[i].frames[at], others[i].frames[at]) * pixels_per_unit > visible)
                return frame;
        }
    }
    return std::nullopt;
}

}  // namespace ropesim
