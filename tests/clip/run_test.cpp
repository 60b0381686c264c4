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

// Damped by 30 a unit of time, the limit is h omega < sqrt(2 (1 + exp(-3))) = 1.45 at 10 steps, where it
// is 1.99: the undamped one says nothing.
TEST(StabilityWarnings, NameNoLimitThatDampingMoves) {
    Scene scene = seed_with(10, "symplectic_euler");
    scene.ropes[0].damping = 30.0;
    EXPECT_THAT(warnings(scene), ElementsAre(HasSubstr("is unstable at 10 steps per frame: 14 or more are")));
}

TEST(StabilityWarnings, SayWhatDampingMakesStable) {
    Scene scene = seed_with(64, "explicit_euler");
    scene.ropes[0].damping_factor = 0.01;  // h omega < 0.1
    EXPECT_THAT(warnings(scene), ElementsAre(HasSubstr("64 steps per frame: 199 or more are stable")));
}

TEST(StabilityWarnings, AreSilentWhereLinksKeepTheirLength) {
    EXPECT_THAT(warnings(seed_with(1, "constraint_projection")), IsEmpty());
}

// 100,000 frames of a million masses would take 1.6 TB.
TEST(Simulate, RefusesToKeepMoreThanMemoryHolds) {
    Scene scene = seed_with(64, "stormer_verlet");
    scene.frames = 100'000;
    scene.ropes[0].nodes = 1'000'000;
    EXPECT_THAT([&] { simulate(scene, {}); },
                testing::ThrowsMessage<std::runtime_error>(
                    HasSubstr("1000000 masses in 100000 frames are to be kept in memory")));
}

TEST(Divergence, SaysWhichRopeMethodFrameAndWhy) {
    const Scene scene = seed_with(8, "symplectic_euler");
    EXPECT_EQ(divergence(scene, runs(scene)[0], 42),
              "rope 'Euler' (symplectic_euler) diverged in frame 42: at 8 steps per frame it is unstable "
              "(h*omega = 2.49, limit 2); 10 or more are stable");
}

}  // namespace
}  // namespace ropesim
