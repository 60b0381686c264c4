#include "compare/compared_scene.h"

#include <algorithm>
#include <array>
#include <stdexcept>

namespace ropesim {
namespace {

// Colours that the colour-blind tell apart, also on black (Okabe, Ito: Color Universal Design, 2008).
constexpr std::array<std::array<std::uint8_t, 3>, most_compared> colors{{{86, 180, 233},
                                                                         {230, 159, 0},
                                                                         {0, 158, 115},
                                                                         {240, 228, 66},
                                                                         {204, 121, 167},
                                                                         {213, 94, 0},
                                                                         {0, 114, 178},
                                                                         {160, 160, 160}}};

std::string run_name(const std::string& method, int steps, bool steps_differ) {
    return steps_differ ? method + ", " + std::to_string(steps) + (steps == 1 ? " step" : " steps") : method;
}

std::vector<SceneRope> runs_of(const Scene& scene, const SceneRope& rope, Choice choice) {
    const bool steps_differ = choice.steps.size() > 1;
    if (choice.methods.empty()) choice.methods = {rope.method};
    if (choice.steps.empty()) choice.steps = {steps_per_frame(scene, rope)};
    const std::size_t count = std::max(choice.methods.size(), choice.steps.size());
    if (std::min(choice.methods.size(), choice.steps.size()) != 1 &&
        choice.methods.size() != choice.steps.size())
        throw std::runtime_error("found " + std::to_string(choice.methods.size()) + " methods and " +
                                 std::to_string(choice.steps.size()) +
                                 " counts of steps; expected as many of the one as of the other, or one");
    choice.methods.resize(count, choice.methods.front());
    choice.steps.resize(count, choice.steps.front());
    std::vector<SceneRope> runs;
    for (std::size_t i = 0; i < count; ++i) {
        SceneRope& run = runs.emplace_back(rope);
        run.method = choice.methods[i];
        run.steps_per_frame = choice.steps[i];
        run.name = run_name(run.method, choice.steps[i], steps_differ);
        run.color = colors[i % colors.size()];
    }
    return runs;
}

void check(const std::vector<SceneRope>& runs) {
    if (runs.size() < 2)
        throw std::runtime_error("a comparison needs two runs or more; found one: " + runs.front().name);
    if (runs.size() > most_compared)
        throw std::runtime_error("found " + std::to_string(runs.size()) + " runs to compare; expected " +
                                 std::to_string(most_compared) + " at most");
    for (const SceneRope& run : runs)
        if (run.nodes != runs.front().nodes)
            throw std::runtime_error("ropes '" + runs.front().name + "' and '" + run.name + "' have " +
                                     std::to_string(runs.front().nodes) + " and " +
                                     std::to_string(run.nodes) + " nodes; expected the same to compare them");
}

}  // namespace

Scene compared_scene(const Scene& scene, const Choice& choice) {
    Scene compared = scene;
    const bool as_they_are = choice.methods.empty() && choice.steps.empty() && choice.rope.empty();
    if (!as_they_are || scene.ropes.size() == 1) {
        Choice runs = choice;
        if (runs.methods.empty() && runs.steps.empty()) runs.methods = {"symplectic_euler", "stormer_verlet"};
        compared.ropes = runs_of(scene, rope_named(scene, choice.rope), runs);
    }
    check(compared.ropes);
    check_scene(compared);
    return compared;
}

std::string label(const Scene& scene, const SceneRope& rope) {
    const int steps = steps_per_frame(scene, rope);
    const std::string name = rope.name.starts_with(rope.method) ? "" : rope.name + ": ";
    return name + rope.method + ", " + std::to_string(steps) +
           (steps == 1 ? " step per frame" : " steps per frame");
}

}  // namespace ropesim
