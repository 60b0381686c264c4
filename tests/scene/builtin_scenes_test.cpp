#include "scene/scene.h"
#include "simulation/diagnostics.h"
#include "simulation/simulate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace ropesim {
namespace {

Scene builtin(std::string_view name) {
    for (const BuiltinScene& each : builtin_scenes())
        if (each.name == name) return parse_scene(each.toml, each.name);
    throw std::runtime_error("no such scene");
}

Stepping stepping_of(const Scene& scene, const SceneRope& rope) {
    Stepping result = stepping(scene.frame_time, steps_per_frame(scene, rope));
    result.damping_factor = rope.damping_factor;
    result.sweeps = rope.sweeps;
    return result;
}

Trajectory run(const Scene& scene, const SceneRope& rope) {
    return simulate(make_rope(scene, rope), find_method(rope.method), stepping_of(scene, rope), scene.frames);
}

bool in_view(const Scene& scene, const SceneRope& rope, const Points& position) {
    const double half_height = scene.view.height / 2.0;
    const double half_width = half_height * scene.size[0] / scene.size[1];
    const double margin =
        std::max(rope.line_width, rope.point_size) / 2.0 * scene.view.height / scene.size[1];
    return ((position.col(0) - scene.view.center.x()).abs() + margin < half_width).all() &&
           ((position.col(1) - scene.view.center.y()).abs() + margin < half_height).all();
}

// The ropes that are there to blow up.
bool blows_up(const BuiltinScene& scene, const SceneRope& rope) {
    return rope.method == "explicit_euler" ||
           (scene.name == "stiff-rope" && rope.method == "symplectic_euler") ||
           (scene.name == "unstable-steps" && !rope.steps_per_frame);
}

// The rope that is there to stretch out of the picture.
bool stretches_away(const BuiltinScene& scene, const SceneRope& rope) {
    return scene.name == "sweeps-stretch" && rope.name == "512 masses, one sweep";
}

TEST(BuiltinScenes, StartWithTheSeedsAndHaveNamesAndSummaries) {
    const std::vector<BuiltinScene> scenes = builtin_scenes();
    ASSERT_FALSE(scenes.empty());
    EXPECT_EQ(scenes[0].name, "seed");
    std::set<std::string_view> names;
    for (const BuiltinScene& scene : scenes) {
        names.insert(scene.name);
        EXPECT_GT(scene.summary.size(), 20U) << scene.name;
        EXPECT_TRUE(scene.toml.starts_with("# " + std::string(scene.summary) + "\n")) << scene.name;
    }
    EXPECT_THAT(names, testing::IsSupersetOf({"seed", "seed-3-nodes", "seed-undamped", "seed-constraints",
                                              "explicit-euler", "bridge", "plucked-string", "heavy-end"}));
}

TEST(BuiltinScenes, ReadBackAsWritten) {
    for (const BuiltinScene& each : builtin_scenes())
        EXPECT_EQ(parse_scene(to_toml(builtin(each.name)), "written"), builtin(each.name)) << each.name;
}

TEST(BuiltinScenes, AreStableButForThoseThatShallBlowUp) {
    for (const BuiltinScene& each : builtin_scenes()) {
        const Scene scene = builtin(each.name);
        for (const SceneRope& rope : scene.ropes) {
            const bool expected = !blows_up(each, rope);
            EXPECT_EQ(stable(make_rope(scene, rope), find_method(rope.method), stepping_of(scene, rope)),
                      expected)
                << each.name << ", " << rope.name;
        }
    }
}

TEST(BuiltinScenes, StayInViewButForThoseThatShallBlowUp) {
    for (const BuiltinScene& each : builtin_scenes()) {
        const Scene scene = builtin(each.name);
        for (const SceneRope& rope : scene.ropes) {
            if (blows_up(each, rope) || stretches_away(each, rope)) continue;
            const Trajectory trajectory = run(scene, rope);
            ASSERT_FALSE(trajectory.diverged) << each.name;
            for (std::size_t frame = 0; frame < trajectory.frames.size(); ++frame)
                ASSERT_TRUE(in_view(scene, rope, trajectory.frames[frame]))
                    << each.name << ", " << rope.name << ", frame " << frame;
        }
    }
}

TEST(BuiltinScenes, TheSeedIsTheAssignments) {
    Scene expected;
    expected.title = "Rope Simulator";
    expected.ropes.resize(2);
    for (SceneRope& rope : expected.ropes) {
        rope.start = {0.0, 200.0};
        rope.end = {-400.0, 200.0};
    }
    expected.ropes[0].name = "Euler";
    expected.ropes[0].color = {0, 0, 255};
    expected.ropes[1].name = "Verlet";
    expected.ropes[1].method = "seed_verlet";
    expected.ropes[1].damping_factor = 0.00005;
    expected.ropes[1].color = {0, 255, 0};
    EXPECT_EQ(builtin("seed"), expected);
}

// The two sum the same numbers in another order: rounding of 2^-53 of 400, in 64 x 120 steps.
TEST(BuiltinScenes, UndampedTheSeedsRopesCoincideToRounding) {
    const Scene scene = builtin("seed-undamped");
    const Trajectory euler = run(scene, scene.ropes[0]);
    const Trajectory verlet = run(scene, scene.ropes[1]);
    EXPECT_NE(scene.ropes[0].method, scene.ropes[1].method);
    for (std::size_t frame = 0; frame < 60; ++frame)
        EXPECT_LT((euler.frames[frame] - verlet.frames[frame]).abs().maxCoeff(), 1e-6);
    const Scene damped = builtin("seed");
    EXPECT_GT(
        (run(damped, damped.ropes[0]).frames[60] - run(damped, damped.ropes[1]).frames[60]).abs().maxCoeff(),
        10.0);
}

TEST(BuiltinScenes, ExplicitEulerBlowsUpBesideOneThatDoesNot) {
    const Scene scene = builtin("explicit-euler");
    bool blew_up = false;
    for (const SceneRope& rope : scene.ropes) {
        const Trajectory trajectory = run(scene, rope);
        const bool gone = trajectory.diverged || !in_view(scene, rope, trajectory.frames.back());
        EXPECT_EQ(gone, rope.method == "explicit_euler") << rope.name;
        blew_up |= gone;
    }
    EXPECT_TRUE(blew_up);
}

}  // namespace
}  // namespace ropesim
