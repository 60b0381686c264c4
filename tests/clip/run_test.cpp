#include "clip/run.h"

#include <gmock/gmock.h>

namespace ropesim {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Scene seed_with(int steps_per_frame, const std::string& method) {
    Scene scene = parse_scene(builtin_scenes().front().toml, "seed");
    scene.steps_per_frame = steps_per_frame;
    scene.frames = 60;
    scene.ropes.resize(1);
    scene.ropes[0].method = method;
    return scene;
}

std::vector<std::string> warnings(const Scene& scene) {
    return stability_warnings(scene, runs(scene));
}

// Sixteen masses of 1 on springs of 100, one end pinned: the greatest frequency of that chain is
// 2 sqrt(100) cos(pi / 31) = 19.897..., so that h < 2 / 19.897 needs 10 steps per unit of time and not 9.
TEST(StabilityWarnings, NameTheFewestStepsThatAreStable) {
    EXPECT_THAT(warnings(seed_with(9, "symplectic_euler")),
                ElementsAre(HasSubstr(
                    "is unstable at 9 steps per frame (h*omega = 2.21, limit 2): 10 or more are stable")));
    EXPECT_THAT(warnings(seed_with(10, "symplectic_euler")), IsEmpty());
    EXPECT_THAT(warnings(seed_with(10, "stormer_verlet")), IsEmpty());
}

TEST(StabilityWarnings, SayThatNoStepOfExplicitEulerIsStable) {
    EXPECT_THAT(warnings(seed_with(100000, "explicit_euler")),
                ElementsAre(HasSubstr("rope 'Euler' (explicit_euler) is unstable at 100000 steps per frame: "
                                      "without damping no step is stable")));
}

TEST(StabilityWarnings, AreSilentWhereLinksKeepTheirLength) {
    EXPECT_THAT(warnings(seed_with(1, "constraint_projection")), IsEmpty());
}

TEST(Divergence, SaysWhichRopeMethodFrameAndWhy) {
    const Scene scene = seed_with(8, "symplectic_euler");
    const auto scene_runs = runs(scene);
    const std::vector<Trajectory> trajectories = simulate(scene, scene_runs);
    ASSERT_TRUE(trajectories[0].diverged);
    const std::string frame = std::to_string(*trajectories[0].diverged);
    EXPECT_EQ(divergence(scene, scene_runs[0], trajectories[0]),
              "rope 'Euler' (symplectic_euler) diverged in frame " + frame +
                  ": at 8 steps per frame it is unstable (h*omega = 2.49, limit 2); 10 or more are stable");
}

TEST(Divergence, EndsOneRopeWhileTheOthersGoOn) {
    Scene scene = seed_with(8, "symplectic_euler");
    SceneRope other = scene.ropes[0];
    other.name = "projected";
    other.method = "constraint_projection";
    scene.ropes.push_back(other);
    const std::vector<Trajectory> trajectories = simulate(scene, runs(scene));
    const Positions last = positions(trajectories, {scene.frames - 1});
    EXPECT_EQ(last.at(scene.frames - 1)[0].rows(), 0);
    EXPECT_EQ(last.at(scene.frames - 1)[1].rows(), 16);
    EXPECT_TRUE(last.at(scene.frames - 1)[1].isFinite().all());
}

// A mass that hangs at rest from a pin, 10 below it: its spring carries its weight of 1.
TEST(DiagnosticsCsv, TellsOfARopeThatHangsAtRest) {
    Scene scene = seed_with(64, "stormer_verlet");
    SceneRope& rope = scene.ropes[0];
    rope.nodes = 2;
    rope.start = {0.0, 10.0};
    rope.end = {0.0, 0.0};
    rope.rest_length = 9.99;  // 1 / 100 shorter: in equilibrium
    const std::string text = diagnostics_csv(scene, simulate(scene, runs(scene)), {0, 59});
    EXPECT_THAT(
        text, testing::StartsWith("frame,rope,kinetic,spring,gravity,largest_stretch,largest_tension,length\n"
                                  "0,Euler,0,"));
    double kinetic = 1.0, spring = 0.0, gravity = 0.0, stretch = 0.0, tension = 0.0, length = 0.0;
    ASSERT_EQ(std::sscanf(text.substr(text.find("59,Euler")).c_str(), "59,Euler,%lf,%lf,%lf,%lf,%lf,%lf",
                          &kinetic, &spring, &gravity, &stretch, &tension, &length),
              6);
    EXPECT_NEAR(kinetic, 0.0, 1e-20);
    EXPECT_NEAR(spring, 0.5 * 100.0 * 0.01 * 0.01, 1e-12);
    EXPECT_NEAR(gravity, 10.0, 1e-12);
    EXPECT_NEAR(stretch, 0.01 / 9.99, 1e-12);
    EXPECT_NEAR(tension, 1.0, 1e-10);
    EXPECT_NEAR(length, 10.0, 1e-12);
}

}  // namespace
}  // namespace ropesim
