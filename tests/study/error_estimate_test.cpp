#include "simulation/error_estimate.h"

#include "study/method_error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace ropesim {
namespace {

// Ropes of all sizes, stiffnesses, pins and directions at steps from coarse to where rounding is in sight;
// damped or not, some by a factor per step.
Scene random_scene(unsigned seed, const Method& method) {
    std::mt19937 engine(seed);
    const auto between = [&](double least, double greatest) {
        return std::uniform_real_distribution(least, greatest)(engine);
    };
    Scene scene;
    scene.frames = seed % 5 == 0 ? 121 : 41;
    scene.steps_per_frame = static_cast<int>(std::pow(2.0, between(3.0, 10.0 - method.order)));
    SceneRope rope;
    rope.method = method.name;
    rope.start = {0.0, 200.0};
    rope.end = {between(-400.0, 400.0), between(-400.0, 100.0)};
    rope.nodes = static_cast<int>(between(2.0, 21.0));
    rope.mass = between(0.5, 3.0);
    rope.stiffness = std::pow(10.0, between(0.5, 3.5));
    rope.sweeps = static_cast<int>(between(1.0, 5.0));
    if (seed % 4 == 1) rope.damping = between(0.0, 0.1);
    if (seed % 4 == 2) rope.damping_factor = between(0.0, 0.001);
    if (seed % 3 == 2) rope.pinned = {0, rope.nodes - 1};
    if (seed % 3 == 2 && rope.nodes > 2) rope.via = {{rope.end.x() / 2.0 + 50.0, -100.0}};
    scene.ropes.push_back(rope);
    return scene;
}

class EveryMethod : public testing::TestWithParam<std::string_view> {};

// Where it claims to be trusted it is within a factor of two of the distance from the truth, in every frame.
TEST_P(EveryMethod, HasAnErrorEstimateThatKeepsItsWord) {
    const Method& method = find_method(GetParam());
    long claims = 0;
    for (unsigned seed = 0; seed < 24; ++seed) {
        const Scene scene = random_scene(seed, method);
        const Problem its_problem = problem(scene, scene.ropes[0]);
        if (!links_at_rest_length(its_problem.rope, its_problem.rope.start)) continue;
        const Truth true_motion = truth(its_problem);
        Stepping step = stepping(its_problem, its_problem.steps_per_frame);
        step.damping_factor = scene.ropes[0].damping_factor;
        const Rope rope = make_rope(scene, scene.ropes[0]);
        MovingRope own(rope, method, step);
        ErrorEstimator estimator(rope, method, step);
        for (std::size_t frame = 1; frame < static_cast<std::size_t>(true_motion.frames); ++frame) {
            own.advance();
            estimator.advance();
            if (own.diverged()) break;
            const auto estimate = estimator.estimate(own.state().position);
            if (!estimate || !estimate->trusted()) continue;
            ++claims;
            const double error = greatest_distance(true_motion.reference.frames[frame], own.state().position);
            ASSERT_LE(error, 2.0 * estimate->error) << seed << ' ' << frame << estimator.description();
            ASSERT_GE(error, 0.5 * estimate->error) << seed << ' ' << frame << estimator.description();
        }
    }
    EXPECT_GT(claims, 200);
}

std::vector<std::string_view> all_names() {
    std::vector<std::string_view> names;
    for (const Method& method : methods()) names.push_back(method.name);
    return names;
}
INSTANTIATE_TEST_SUITE_P(Table, EveryMethod, testing::ValuesIn(all_names()),
                         [](const auto& method) { return std::string(method.param); });

}  // namespace
}  // namespace ropesim
