#include "clip/run.h"

#include "simulation/diagnostics.h"

#include <array>
#include <cstdio>

namespace ropesim {
namespace {

std::string title(const Run& run) {
    return "rope '" + run.description->name + "' (" + std::string(run.method->name) + ")";
}

// What would be stable: "10 or more are stable".
std::string remedy(const Scene& scene, const Run& run) {
    const auto fewest =
        fewest_stable_steps(run.rope, *run.method, scene.frame_time, run.stepping.damping_factor);
    if (fewest) return std::to_string(*fewest) + " or more are stable";
    const bool damped = run.rope.damping > 0.0 || run.stepping.damping_factor > 0.0;
    return damped ? "not even " + std::to_string(most_steps) + " are stable"
                  : "without damping no step is stable";
}

// How far the steps are from what is stable, where the undamped limit tells: " (h*omega = 2.5, limit 2)".
std::string excess(const Run& run) {
    const double h_omega = run.stepping.step_size * greatest_frequency(run.rope);
    if (run.method->stability_limit == 0.0 || h_omega < run.method->stability_limit) return "";
    std::array<char, 64> text;
    std::snprintf(text.data(), text.size(), " (h*omega = %.3g, limit %.4g)", h_omega,
                  run.method->stability_limit);
    return text.data();
}

}  // namespace

std::vector<Run> runs(const Scene& scene) {
    std::vector<Run> result;
    for (const SceneRope& rope : scene.ropes) {
        Stepping each = stepping(scene.frame_time, steps_per_frame(scene, rope));
        each.damping_factor = rope.damping_factor;
        each.sweeps = rope.sweeps;
        result.push_back({&rope, &find_method(rope.method), make_rope(scene, rope), each});
    }
    return result;
}

std::vector<Trajectory> simulate(const Scene& scene, const std::vector<Run>& runs) {
    check_kept(static_cast<double>(masses(scene)), scene.frames);
    std::vector<Trajectory> trajectories;
    for (const Run& run : runs)
        trajectories.push_back(simulate(run.rope, *run.method, run.stepping, scene.frames));
    return trajectories;
}

std::vector<std::string> stability_warnings(const Scene& scene, const std::vector<Run>& runs) {
    std::vector<std::string> warnings;
    for (const Run& run : runs)
        if (!stable(run.rope, *run.method, run.stepping))
            warnings.push_back(title(run) + " is unstable at " + std::to_string(run.stepping.steps) +
                               " steps per frame" + excess(run) + ": " + remedy(scene, run));
    return warnings;
}

std::string divergence(const Scene& scene, const Run& run, long frame) {
    return title(run) + " diverged in frame " + std::to_string(frame) + ": at " +
           std::to_string(run.stepping.steps) + " steps per frame it is " +
           (stable(run.rope, *run.method, run.stepping)
                ? "stable to linear theory, but the motion is too violent for it"
                : "unstable" + excess(run) + "; " + remedy(scene, run));
}

Positions positions(const std::vector<Trajectory>& trajectories, const FrameList& frames) {
    Positions positions;
    for (const long frame : frames) {
        std::vector<Points>& ropes = positions[frame];
        for (const Trajectory& trajectory : trajectories) {
            const auto index = static_cast<std::size_t>(frame);
            ropes.push_back(index < trajectory.frames.size() ? trajectory.frames[index] : Points(0, 2));
        }
    }
    return positions;
}

}  // namespace ropesim
