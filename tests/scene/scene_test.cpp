#include "scene/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace ropesim {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

SceneRope a_rope() {
    SceneRope rope;
    rope.name = "Euler";
    rope.start = {0.0, 200.0};
    rope.end = {-400.0, 200.0};
    return rope;
}

Scene a_scene() {
    Scene scene;
    scene.ropes = {a_rope()};
    return scene;
}

template <class Change>
std::string refusal(Change change) {
    Scene scene = a_scene();
    change(scene, scene.ropes[0]);
    try {
        check_scene(scene);
        return "accepted";
    } catch (const std::runtime_error& error) {
        return error.what();
    }
}

TEST(Scene, DefaultsAreTheAssignments) {
    const Scene scene = a_scene();
    EXPECT_EQ(scene.steps_per_frame, 64);
    EXPECT_EQ(scene.frame_time, 1.0);
    EXPECT_EQ(scene.size, (std::array<int, 2>{960, 640}));
    EXPECT_EQ(scene.view.height, 640.0);  // one world unit is one pixel
    EXPECT_TRUE((scene.gravity == Eigen::Array2d(0.0, -1.0)).all());
    EXPECT_EQ(scene.background, (std::array<std::uint8_t, 3>{0, 0, 0}));
    EXPECT_EQ(scene.ropes[0].nodes, 16);
    EXPECT_EQ(scene.ropes[0].mass, 1.0);
    EXPECT_EQ(scene.ropes[0].stiffness, 100.0);
    EXPECT_EQ(scene.ropes[0].pinned, std::vector<int>{0});
    EXPECT_EQ(scene.ropes[0].line_width, 4.0);
    EXPECT_EQ(scene.ropes[0].point_size, 8.0);
}

TEST(CheckScene, NamesTheRopeAndTheKey) {
    EXPECT_EQ(refusal([](Scene&, SceneRope&) {}), "accepted");
    EXPECT_THAT(refusal([](Scene&, SceneRope& rope) { rope.mass = 0.0; }), StartsWith("rope 'Euler': mass"));
    EXPECT_THAT(refusal([](Scene& scene, SceneRope&) { scene.frames = 0; }),
                testing::AllOf(StartsWith("frames"), HasSubstr("0"), HasSubstr("1 to 10000000")));
    EXPECT_THAT(refusal([](Scene& scene, SceneRope&) { scene.view.height = 0.0; }), HasSubstr("height"));
}

TEST(CheckScene, RefusesWhatNoRopeCanBe) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    const auto refused = [](const char* key, auto change) {
        EXPECT_THAT(refusal(change), HasSubstr(key));
        EXPECT_NE(refusal(change), "accepted") << key;
    };
    refused("stiffness", [](Scene&, SceneRope& rope) { rope.stiffness = -1.0; });
    refused("stiffness", [](Scene&, SceneRope& rope) { rope.stiffness = nan; });
    refused("start", [](Scene&, SceneRope& rope) { rope.start.x() = nan; });
    refused("nodes", [](Scene&, SceneRope& rope) { rope.nodes = 1; });
    refused("pinned", [](Scene&, SceneRope& rope) { rope.pinned = {16}; });
    refused("pinned", [](Scene&, SceneRope& rope) { rope.pinned = {-17}; });
    refused("pinned", [](Scene&, SceneRope& rope) { rope.pinned = {15, -1}; });
    refused("pinned", [](Scene&, SceneRope& rope) { rope.pinned = {std::numeric_limits<int>::min()}; });
    refused("masses", [](Scene&, SceneRope& rope) { rope.masses = {1.0, 2.0}; });
    refused("masses", [](Scene&, SceneRope& rope) { rope.masses.assign(16, 0.0); });
    refused("damping_factor", [](Scene&, SceneRope& rope) { rope.damping_factor = 1.0; });
    refused("damping_factor", [](Scene&, SceneRope& rope) { rope.damping = rope.damping_factor = 0.5; });
    refused("method", [](Scene&, SceneRope& rope) { rope.method = "euler"; });
    refused("name", [](Scene&, SceneRope& rope) { rope.name = ""; });
    refused("name", [](Scene&, SceneRope& rope) { rope.name = "two\nlines"; });
    refused("name", [](Scene&, SceneRope& rope) { rope.name = "\xff"; });
    refused("title", [](Scene& scene, SceneRope&) { scene.title = "\u0085"; });
    refused("title", [](Scene& scene, SceneRope&) { scene.title = std::string(201, 'x'); });
    refused("Euler", [](Scene& scene, SceneRope& rope) { scene.ropes.push_back(SceneRope(rope)); });
    refused("rope", [](Scene& scene, SceneRope&) { scene.ropes.clear(); });
}

TEST(CheckScene, AcceptsTheEndsOfRanges) {
    EXPECT_EQ(refusal([](Scene&, SceneRope& rope) { rope.pinned = {0, -1, 1, -2}; }), "accepted");
    EXPECT_EQ(refusal([](Scene&, SceneRope& rope) { rope.pinned = {}; }), "accepted");
    EXPECT_EQ(refusal([](Scene&, SceneRope& rope) { rope.nodes = 2; }), "accepted");
    EXPECT_EQ(refusal([](Scene&, SceneRope& rope) { rope.damping_factor = 0.9999; }), "accepted");
    EXPECT_EQ(refusal([](Scene& scene, SceneRope&) { scene.size = {16384, 1}; }), "accepted");
    EXPECT_EQ(refusal([](Scene& scene, SceneRope&) { scene.title = std::string(200, 'x'); }), "accepted");
}

// `mass` has no say beside `masses`: to let it be set would lose it in to_toml.
TEST(CheckScene, RefusesAMassThatHasNoSay) {
    EXPECT_THAT(refusal([](Scene&, SceneRope& rope) {
                    rope.masses.assign(16, 2.0);
                    rope.mass = 3.0;
                }),
                HasSubstr("mass"));
}

TEST(CheckScene, RefusesLinksWithoutADirection) {
    const auto same_point = [](Scene&, SceneRope& rope) { rope.end = rope.start; };
    EXPECT_THAT(refusal(same_point), HasSubstr("end"));
    // There and back in three links: the middle one would join two masses at the same place.
    const auto folded = [](Scene&, SceneRope& rope) {
        rope.via = {rope.end};
        rope.end = rope.start;
        rope.nodes = 4;
    };
    EXPECT_THAT(refusal(folded), HasSubstr("via"));
    // The masses are nearer to each other than doubles are, so far from the origin.
    const auto crowded = [](Scene&, SceneRope& rope) {
        rope.start = {1e9, 0.0};
        rope.end = {1e9 + 1e-6, 0.0};
        rope.nodes = 1000;
    };
    EXPECT_NE(refusal(crowded), "accepted");
    // The square of this distance is zero.
    EXPECT_NE(refusal([](Scene&, SceneRope& rope) {
                  rope.start = {0.0, 0.0};
                  rope.end = {1e-200, 0.0};
              }),
              "accepted");
}

TEST(CheckScene, BoundsTheMassesOfAllRopesTogether) {
    EXPECT_NE(refusal([](Scene& scene, SceneRope& rope) {
                  rope.nodes = 1'000'000;
                  const SceneRope big = rope;
                  for (int i = 1; i < 60; ++i) {
                      scene.ropes.push_back(big);
                      scene.ropes.back().name += std::to_string(i);
                  }
              }),
              "accepted");
}

TEST(MakeRope, SpacesTheMassesEvenly) {
    const Rope rope = make_rope(a_scene(), a_rope());
    ASSERT_EQ(rope.start.rows(), 16);
    for (int i = 0; i < 16; ++i) {
        EXPECT_DOUBLE_EQ(rope.start(i, 0), -400.0 * i / 15.0);
        EXPECT_EQ(rope.start(i, 1), 200.0);
    }
    EXPECT_DOUBLE_EQ(rope.rest_length, 400.0 / 15.0);
    EXPECT_TRUE((rope.mass == 1.0).all());
}

TEST(MakeRope, PutsTheEndsWhereTheyAreSaidToBe) {
    SceneRope description = a_rope();
    description.start = {0.1, 0.7};
    description.end = {1e5 / 3.0, -0.3};
    for (int nodes = 2; nodes < 200; ++nodes) {
        description.nodes = nodes;
        const Points start = make_rope(a_scene(), description).start;
        EXPECT_TRUE((start.row(0).transpose() == description.start).all());
        EXPECT_TRUE((start.row(nodes - 1).transpose() == description.end).all());
    }
}

TEST(MakeRope, IsSymmetricToTheBit) {
    SceneRope description = a_rope();
    description.start = {-333.3, 100.1};
    description.end = {333.3, 100.1};
    for (int nodes = 2; nodes < 100; ++nodes) {
        description.nodes = nodes;
        const Points start = make_rope(a_scene(), description).start;
        EXPECT_TRUE((start.col(0) == -start.col(0).reverse()).all()) << nodes;
        EXPECT_TRUE((start.col(1) == 100.1).all()) << nodes;
    }
}

// Three sides of a square of side 3, nine links: a mass at each corner, one unit apart.
TEST(MakeRope, GoesAlongTheCorners) {
    SceneRope description = a_rope();
    description.start = {0.0, 0.0};
    description.via = {{3.0, 0.0}, {3.0, 3.0}};
    description.end = {0.0, 3.0};
    description.nodes = 10;
    const Rope rope = make_rope(a_scene(), description);
    Points expected(10, 2);
    expected << 0, 0, 1, 0, 2, 0, 3, 0, 3, 1, 3, 2, 3, 3, 2, 3, 1, 3, 0, 3;
    EXPECT_TRUE(rope.start.isApprox(expected, 1e-15));
    EXPECT_DOUBLE_EQ(rope.rest_length, 1.0);
}

// Of a rope over a corner that no mass falls on, the way between masses is the rest length.
TEST(MakeRope, MeasuresTheRestLengthAlongThePath) {
    SceneRope description = a_rope();
    description.start = {0.0, 0.0};
    description.via = {{3.0, 4.0}};
    description.end = {6.0, 0.0};
    description.nodes = 5;  // links of 10 / 4
    const Rope rope = make_rope(a_scene(), description);
    EXPECT_DOUBLE_EQ(rope.rest_length, 2.5);
    description.nodes = 4;  // the middle link cuts the corner
    const Points start = make_rope(a_scene(), description).start;
    EXPECT_NEAR(start(1, 0), 2.0, 1e-14);
    EXPECT_NEAR(start(1, 1), 8.0 / 3.0, 1e-14);
    EXPECT_NEAR(start(2, 0), 4.0, 1e-14);
    EXPECT_NEAR(start(2, 1), 8.0 / 3.0, 1e-14);
}

TEST(MakeRope, TakesWhatTheSceneSays) {
    Scene scene = a_scene();
    scene.gravity = {0.5, -2.0};
    SceneRope description = a_rope();
    description.nodes = 3;
    description.masses = {1.0, 2.0, 4.0};
    description.rest_length = 7.0;
    description.stiffness = 50.0;
    description.damping = 0.25;
    description.pinned = {-1, 0};
    const Rope rope = make_rope(scene, description);
    EXPECT_TRUE((rope.mass == Eigen::Array3d(1.0, 2.0, 4.0)).all());
    EXPECT_EQ(rope.rest_length, 7.0);
    EXPECT_EQ(rope.stiffness, 50.0);
    EXPECT_EQ(rope.damping, 0.25);
    EXPECT_THAT(rope.pinned, testing::UnorderedElementsAre(0, 2));
    EXPECT_TRUE((rope.inverse_mass == Eigen::Array3d(0.0, 0.5, 0.0)).all());
    EXPECT_TRUE((rope.gravity == scene.gravity).all());
}

}  // namespace
}  // namespace ropesim
