#include "study/plan.h"

#include "clip/file.h"
#include "commands/commands.h"
#include "commands/scene_options.h"
#include "scene/words.h"
#include "study/timing.h"

#include <CLI/CLI.hpp>

#include <array>
#include <cmath>
#include <cstdio>
#include <memory>

namespace ropesim {
namespace {

struct PlanOptions {
    SceneOptions scene;
    double tolerance = 0.5;
    std::string file;
};

void add_options(CLI::App& app, PlanOptions& options) {
    add_scene_options(app, options.scene);
    app.add_option("--tolerance", options.tolerance, "how far any mass may be from the truth, in pixels")
        ->type_name("PX")
        ->capture_default_str();
    app.add_option("--write", options.file, "save the scene with what was chosen")->type_name("FILE");
    app.footer(
        "Examples:\n"
        "  ropesim plan --tolerance 0.001\n"
        "  ropesim plan my.toml --tolerance 0.5 --write planned.toml");
}

std::string title(const Candidate& candidate) {
    return std::string(candidate.method->name) + ", " + std::to_string(candidate.steps) +
           (candidate.steps == 1 ? " step" : " steps") + " per frame";
}

// Median times per frame, seconds, taken in turns.
std::vector<double> times(const Problem& problem, const std::vector<Candidate>& candidates) {
    std::vector<std::function<void()>> tasks;
    for (const Candidate& each : candidates)
        tasks.push_back([&problem, &each] { simulate(problem, *each.method, each.steps); });
    std::vector<double> result;
    for (const Times& each : times_of(tasks))
        result.push_back(each.median / static_cast<double>(problem.frames));
    return result;
}

void say(const char* role, const Candidate& candidate, double seconds, double share) {
    std::printf("  %-11s %s: ", role, title(candidate).c_str());
    if (!std::isfinite(candidate.error)) {
        std::printf("diverges\n");
        return;
    }
    std::printf("off by %.3g px at worst, %.3g us per frame", candidate.error, 1e6 * seconds);
    if (share > 0.0) std::printf(" (%.3g times the cost)", share);
    std::printf("\n");
}

// The neighbours of the choice among the trials that nothing beats.
void say_what_would_change(const Plan& plan, const Candidate& choice) {
    const std::vector<Candidate> front = efficient(plan);
    for (std::size_t i = 0; i < front.size(); ++i) {
        if (front[i].method != choice.method || front[i].steps != choice.steps) continue;
        if (i > 0)
            std::printf("  %-11s from %.3g px on: %s\n", "looser", front[i - 1].error,
                        title(front[i - 1]).c_str());
        if (i + 1 < front.size())
            std::printf("  %-11s below %.3g px: %s (%.3g px)\n", "tighter", front[i].error,
                        title(front[i + 1]).c_str(), front[i + 1].error);
    }
}

void say_how_far_it_can_be_known(const Problem& problem, const Plan& plan) {
    std::printf("  %-11s of 1e-9 px grows to %.2g px by the last frame\n", "a disturbance",
                1e-9 * plan.growth);
    if (plan.truth.frames < problem.frames)
        std::printf("  %-11s is too chaotic to be known beyond frame %ld of %ld: no step can promise more\n",
                    "the motion", plan.truth.frames - 1, problem.frames - 1);
}

bool plan_rope(const PlanOptions& options, const Scene& scene, SceneRope& rope) {
    const Problem its_problem = problem(scene, rope);
    const Plan found = plan(its_problem, options.tolerance);
    std::printf("rope '%s': %d masses, %d frames, at most %g px\n", rope.name.c_str(), rope.nodes,
                scene.frames, options.tolerance);
    if (!found.choice) {
        const std::vector<Candidate> front = efficient(found);
        if (front.empty())
            std::printf("  nothing keeps to it\n");
        else
            std::printf("  nothing keeps to it; the nearest is %s: off by %.3g px at worst\n",
                        title(front.back()).c_str(), front.back().error);
        say_how_far_it_can_be_known(its_problem, found);
        return false;
    }
    std::vector<Candidate> candidates{*found.choice};
    if (rope.method != auto_method)
        candidates.push_back(
            candidate(its_problem, found.truth, find_method(rope.method), its_problem.steps_per_frame));
    if (found.runner_up) candidates.push_back(*found.runner_up);
    const std::vector<double> seconds = times(its_problem, candidates);
    say("take", candidates[0], seconds[0], 0.0);
    for (std::size_t i = 1; i < candidates.size(); ++i)
        say(i == 1 && rope.method != auto_method ? "as written" : "runner-up", candidates[i], seconds[i],
            seconds[i] / seconds[0]);
    say_what_would_change(found, *found.choice);
    say_how_far_it_can_be_known(its_problem, found);
    rope = planned_rope(rope, its_problem, *found.choice);
    return true;
}

void check_tolerance(double pixels) {
    if (!(pixels >= 1e-9 && pixels <= 1e6))
        throw CLI::ValidationError("--tolerance", "expected 1e-9 to 1e6 pixels");
}

int plan_scene(const PlanOptions& options) {
    check_tolerance(options.tolerance);
    Scene scene = open_scene(options.scene).scene;
    if (!options.file.empty()) check_writable(options.file);
    const Scene as_written = scene;
    bool all = true;
    for (SceneRope& rope : scene.ropes) all = plan_rope(options, as_written, rope) && all;
    if (!all)
        throw std::runtime_error("the tolerance cannot be kept" +
                                 std::string(options.file.empty() ? "" : "; nothing was written"));
    if (options.file.empty()) return 0;
    write_file(options.file, to_toml(scene), Place::named);
    std::printf("written to %s\n", one_line(options.file).c_str());
    return 0;
}

}  // namespace

Command plan_command(CLI::App& app) {
    const auto options = std::make_shared<PlanOptions>();
    add_options(app, *options);
    return [options] { return plan_scene(*options); };
}

}  // namespace ropesim
