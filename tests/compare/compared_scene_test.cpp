#include "compare/compared_scene.h"

#include <gmock/gmock.h>

namespace ropesim {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

Scene seed() {
    return parse_scene(builtin_scenes().front().toml, "seed");
}

TEST(ComparedScene, IsTheScenesOwnRopesWhereNothingElseIsChosen) {
    EXPECT_EQ(compared_scene(seed(), {}), seed());
}

TEST(ComparedScene, MovesASingleRopeByEulerAndVerlet) {
    Scene scene = seed();
    scene.ropes.resize(1);
    const Scene compared = compared_scene(scene, {});
    ASSERT_EQ(compared.ropes.size(), 2u);
    EXPECT_EQ(compared.ropes[0].method, "symplectic_euler");
    EXPECT_EQ(compared.ropes[1].method, "stormer_verlet");
    EXPECT_EQ(steps_per_frame(compared, compared.ropes[1]), 64);
}

TEST(ComparedScene, MovesTheChosenRopeAtEveryCountOfSteps) {
    const Scene compared = compared_scene(seed(), {"Verlet", {"stormer_verlet"}, {10, 16, 64}});
    ASSERT_EQ(compared.ropes.size(), 3u);
    for (const SceneRope& rope : compared.ropes) {
        EXPECT_EQ(rope.method, "stormer_verlet");
        EXPECT_EQ(rope.damping_factor, seed().ropes[1].damping_factor);
    }
    EXPECT_EQ(compared.ropes[2].steps_per_frame, 64);
    EXPECT_EQ(compared.ropes[0].name, "stormer_verlet, 10 steps");
    EXPECT_NE(compared.ropes[0].color, compared.ropes[1].color);
}

TEST(ComparedScene, PairsAsManyMethodsAsSteps) {
    const Scene compared = compared_scene(seed(), {"", {"symplectic_euler", "blanes_moan_4"}, {64, 4}});
    ASSERT_EQ(compared.ropes.size(), 2u);
    EXPECT_EQ(compared.ropes[1].method, "blanes_moan_4");
    EXPECT_EQ(compared.ropes[1].steps_per_frame, 4);
    EXPECT_THAT(
        [] {
            compared_scene(seed(), {"", {"symplectic_euler", "blanes_moan_4"}, {64, 4, 2}});
        },
        ThrowsMessage<std::runtime_error>(HasSubstr("2 methods and 3 counts of steps")));
}

TEST(ComparedScene, RefusesWhatCannotBeCompared) {
    EXPECT_THAT(
        [] {
            compared_scene(seed(), {"", {"stormer_verlet"}, {}});
        },
        ThrowsMessage<std::runtime_error>(HasSubstr("needs two runs")));
    EXPECT_THAT(
        [] {
            compared_scene(seed(), {"Rope", {}, {1, 2}});
        },
        ThrowsMessage<std::runtime_error>(HasSubstr("expected one of: 'Euler', 'Verlet'")));
    EXPECT_THAT(
        [] {
            compared_scene(seed(), {"", {}, {1, 2, 3, 4, 5, 6, 7, 8, 9}});
        },
        ThrowsMessage<std::runtime_error>(HasSubstr("8 at most")));
    Scene scene = seed();
    scene.ropes[1].nodes = 3;
    EXPECT_THAT([&] { compared_scene(scene, {}); },
                ThrowsMessage<std::runtime_error>(HasSubstr("have 16 and 3 nodes")));
}

}  // namespace
}  // namespace ropesim
