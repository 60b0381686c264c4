#include "study/method_error.h"

#include "simulation/diagnostics.h"
#include "simulation/links.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace ropesim {

Problem problem(const Scene& scene, const SceneRope& description) {
    check_kept(description.nodes, scene.frames);
    Problem problem;
    problem.rope = make_rope(scene, description);
    problem.model =
        description.method == auto_method ? Model::elastic : find_method(description.method).model;
    problem.frame_time = scene.frame_time;
    problem.frames = scene.frames;
    problem.pixels_per_unit = scene.size[1] / scene.view.height;
    problem.steps_per_frame = steps_per_frame(scene, description);
    problem.sweeps = description.sweeps;
    Stepping step = stepping(scene.frame_time, problem.steps_per_frame);
    step.damping_factor = description.damping_factor;
    problem.rope.damping = damping_per_step(problem.rope, step) / step.step_size;
    if (!std::isfinite(problem.rope.damping))
        throw std::runtime_error("rope '" + description.name +
                                 "': a damping factor of 1 stops it at once; expected one below 1");
    return problem;
}

std::string obstacle(const Problem& problem, Model model) {
    if (model == problem.model) return "";
    if (model == Model::elastic) return "moves springs, and this rope's links keep their length";
    if (links_at_rest_length(problem.rope, problem.rope.start)) return "";
    return "keeps links at rest length, and this rope's do not start at it";
}

bool fits(const Problem& problem, const Method& method) {
    return obstacle(problem, method.model).empty();
}

Stepping stepping(const Problem& problem, long steps_per_frame) {
    Stepping result = stepping(problem.frame_time, steps_per_frame);
    result.sweeps = problem.sweeps;
    return result;
}

Trajectory simulate(const Problem& problem, const Method& method, long steps_per_frame) {
    return simulate(problem.rope, method, stepping(problem, steps_per_frame), problem.frames);
}

Truth truth(const Problem& problem) {
    Truth truth;
    truth.reference = reference(problem.rope, problem.model, problem.frame_time, problem.frames);
    truth.frames = believed_frames(truth.reference, believed_error / problem.pixels_per_unit);
    for (long frame = 0; frame < truth.frames; ++frame)
        truth.error = std::max(
            truth.error, truth.reference.error[static_cast<std::size_t>(frame)] * problem.pixels_per_unit);
    return truth;
}

MethodError method_error(const Problem& problem, const Truth& truth, const std::vector<Points>& frames) {
    const auto believed = static_cast<std::size_t>(truth.frames);
    MethodError error;
    for (std::size_t frame = 0; frame < std::min(believed, frames.size()); ++frame) {
        error.of_frame.push_back(problem.pixels_per_unit *
                                 greatest_distance(truth.reference.frames[frame], frames[frame]));
        error.worst = std::max(error.worst, error.of_frame.back());
        error.last = error.of_frame.back();
    }
    if (frames.size() < believed) error.worst = error.last = std::numeric_limits<double>::infinity();
    return error;
}

}  // namespace ropesim
