#include "study/plan.h"

#include "simulation/diagnostics.h"
#include "study/sundials_run.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

namespace ropesim {
namespace {

using testing::HasSubstr;

Scene one_rope(const char* method) {
    Scene scene;
    scene.frames = 61;
    SceneRope rope;
    rope.name = "rope";
    rope.method = method;
    rope.start = {0.0, 200.0};
    rope.end = {-400.0, 200.0};
    scene.ropes.push_back(rope);
    return scene;
}

// Ropes of two to twenty masses in every direction, of soft to stiff springs, with one pin, two or none.
Scene random_scene(unsigned seed) {
    std::mt19937 engine(seed);
    const auto between = [&](double least, double greatest) {
        return std::uniform_real_distribution(least, greatest)(engine);
    };
    Scene scene = one_rope(seed % 3 == 0 ? "direct_projection" : "symplectic_euler");
    scene.frames = static_cast<int>(between(20.0, 80.0));
    scene.frame_time = between(0.5, 2.0);
    scene.view.height = between(400.0, 1200.0);
    scene.gravity = {between(-0.5, 0.5), between(-2.0, -0.5)};
    SceneRope& rope = scene.ropes[0];
    rope.end = {between(-400.0, 400.0), between(-400.0, 100.0)};
    rope.nodes = static_cast<int>(between(2.0, 21.0));
    rope.mass = between(0.2, 3.0);
    rope.stiffness = std::pow(10.0, between(1.0, 4.0));
    if (seed % 2 == 0) rope.damping = between(0.0, 0.1);
    return scene;
}

// The greatest distance from a run that shares neither code nor formulation with the truth of the plan.
double independent_error(const Problem& problem, const Candidate& choice, long frames) {
    const Run other = sundials_run(problem.rope, problem.model, problem.frame_time, frames);
    const Trajectory own = simulate(problem, *choice.method, choice.steps);
    double worst = 0.0;
    for (std::size_t frame = 0; frame < other.position.size(); ++frame)
        worst = std::max(worst, greatest_distance(other.position[frame], own.frames[frame]));
    EXPECT_EQ(other.position.size(), static_cast<std::size_t>(frames));
    return worst * problem.pixels_per_unit;
}

TEST(Plan, KeepsItsPromiseOnScenesItHasNotSeen) {
    for (unsigned seed = 0; seed < 10; ++seed) {
        const Scene scene = random_scene(seed);
        const Problem its_problem = problem(scene, scene.ropes[0]);
        for (const double tolerance : {0.5, 0.001}) {
            const Plan found = plan(its_problem, tolerance);
            ASSERT_TRUE(found.choice) << seed;
            EXPECT_LE(found.choice->error, tolerance) << seed;
            EXPECT_NEAR(independent_error(its_problem, *found.choice, found.truth.frames),
                        found.choice->error, 1e-3 * tolerance)
                << seed;
        }
    }
}

// The work of a choice is no more than that of any method at any power of two of steps that keeps to it too.
TEST(Plan, FindsNothingDearerThanATableOfPowersOfTwo) {
    const Scene scene = one_rope("symplectic_euler");
    const Problem its_problem = problem(scene, scene.ropes[0]);
    for (const double tolerance : {10.0, 0.5, 0.01, 1e-5}) {
        const Plan found = plan(its_problem, tolerance);
        ASSERT_TRUE(found.choice);
        for (const Method& method : methods()) {
            for (long steps = 1; steps <= 256; steps *= 2) {
                const Candidate other = candidate(its_problem, found.truth, method, steps);
                if (other.error <= tolerance) {
                    EXPECT_LE(found.choice->work, other.work)
                        << tolerance << ' ' << method.name << ' ' << steps;
                }
            }
        }
    }
}

// Its method at a tenth fewer steps is off by more.
TEST(Plan, TakesNoMoreStepsThanItMust) {
    const Scene scene = one_rope("symplectic_euler");
    const Problem its_problem = problem(scene, scene.ropes[0]);
    const Plan found = plan(its_problem, 0.001);
    const long fewer = static_cast<long>(std::floor(static_cast<double>(found.choice->steps) / 1.1)) - 1;
    EXPECT_GT(candidate(its_problem, found.truth, *found.choice->method, fewer).error, 0.001);
    ASSERT_TRUE(found.runner_up);
    EXPECT_NE(found.runner_up->method, found.choice->method);
    EXPECT_LE(found.runner_up->error, 0.001);
}

// 64 masses, k = 40000, m = 0.25: the links hardly stretch, and a spring's period is far below a frame.
TEST(Plan, TakesLinksThatDoNotStretchForAStiffRope) {
    Scene scene = one_rope("symplectic_euler");
    scene.frames = 21;
    scene.ropes[0].nodes = 64;
    scene.ropes[0].mass = 0.25;
    scene.ropes[0].stiffness = 40000.0;
    const Problem its_problem = problem(scene, scene.ropes[0]);
    EXPECT_EQ(plan(its_problem, 0.5).choice->method->name, "direct_projection");
    EXPECT_EQ(plan(its_problem, 0.001).choice->method->model, Model::elastic);
}

// Links that start stretched are springs'.
TEST(Plan, LeavesOutWhatDoesNotFit) {
    Scene scene = one_rope("stormer_verlet");
    scene.ropes[0].rest_length = 20.0;
    for (const Candidate& trial : plan(problem(scene, scene.ropes[0]), 0.5).tried)
        EXPECT_EQ(trial.method->model, Model::elastic);
    scene.ropes[0].rest_length.reset();
    scene.ropes[0].method = "direct_projection";
    for (const Candidate& trial : plan(problem(scene, scene.ropes[0]), 0.5).tried)
        EXPECT_EQ(trial.method->model, Model::inextensible);
}

TEST(Plan, ChoosesNothingWhereNothingKeepsToTheTolerance) {
    Scene scene = one_rope("stormer_verlet");
    scene.frames = 121;
    const Plan found = plan(problem(scene, scene.ropes[0]), 1e-9);
    EXPECT_FALSE(found.choice);
    EXPECT_FALSE(efficient(found).empty());
    EXPECT_GT(found.growth, 1e4);  // which is why: rounding is magnified as well
}

// A mass on a spring goes round and round: what is disturbed stays disturbed, and does not grow.
TEST(Plan, KnowsHowFarADisturbanceGrows) {
    Scene scene = one_rope("stormer_verlet");
    scene.ropes[0].nodes = 2;
    scene.ropes[0].end = {0.0, 0.0};
    scene.ropes[0].rest_length = 150.0;
    const Plan found = plan(problem(scene, scene.ropes[0]), 0.5);
    EXPECT_LT(found.growth, 10.0);
}

TEST(PlannedRope, KeepsThePhysicsAndChangesMethodAndSteps) {
    Scene scene = one_rope("seed_verlet");
    scene.ropes[0].damping_factor = 0.001;
    const Problem its_problem = problem(scene, scene.ropes[0]);
    const Plan found = plan(its_problem, 0.5);
    scene.ropes[0] = planned_rope(scene.ropes[0], its_problem, *found.choice);
    check_scene(scene);
    const Problem again = problem(scene, scene.ropes[0]);
    EXPECT_EQ(again.steps_per_frame, found.choice->steps);
    EXPECT_NEAR(again.rope.damping, its_problem.rope.damping, 1e-12);
    EXPECT_NEAR(its_problem.rope.damping, -64.0 * std::log(0.999), 1e-12);
}

TEST(WithPlannedRopes, ChangesOnlyRopesThatAskForIt) {
    Scene scene = one_rope("auto");
    scene.ropes.push_back(one_rope("symplectic_euler").ropes[0]);
    scene.ropes[1].name = "other";
    scene.tolerance = 0.01;
    const Scene planned = with_planned_ropes(scene);
    EXPECT_EQ(planned.ropes[1], scene.ropes[1]);
    const Candidate expected = plan(problem(scene, scene.ropes[0]), 0.01).choice.value();
    EXPECT_EQ(planned.ropes[0].method, expected.method->name);
    EXPECT_EQ(planned.ropes[0].steps_per_frame, expected.steps);
    EXPECT_EQ(with_planned_ropes(planned), planned);
    scene.tolerance = 1e-9;
    scene.frames = 121;
    EXPECT_THAT([&] { with_planned_ropes(scene); },
                testing::ThrowsMessage<std::runtime_error>(
                    HasSubstr("rope 'rope': no method keeps to 1e-09 px over 121 frames")));
}

}  // namespace
}  // namespace ropesim
