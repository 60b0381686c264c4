#include "study/method_error.h"

#include <gmock/gmock.h>

#include <cmath>

namespace ropesim {
namespace {

Scene small_scene() {
    Scene scene;
    scene.frames = 11;
    scene.steps_per_frame = 50;
    scene.frame_time = 0.5;
    scene.size = {960, 640};
    scene.view.height = 320.0;
    SceneRope rope;
    rope.name = "first";
    rope.nodes = 5;
    rope.end = {-100.0, 0.0};
    rope.method = "stormer_verlet";
    rope.damping_factor = 0.01;
    scene.ropes.push_back(rope);
    rope.name = "second";
    rope.method = "direct_projection";
    rope.damping_factor = 0.0;
    rope.damping = 0.25;
    scene.ropes.push_back(rope);
    return scene;
}

TEST(Problem, TurnsTheFactorPerStepIntoItsRate) {
    const Scene scene = small_scene();
    const Problem first = problem(scene, rope_named(scene, ""));
    EXPECT_NEAR(first.rope.damping, -std::log(0.99) / 0.01, 1e-13);
    EXPECT_EQ(first.model, Model::elastic);
    const Problem second = problem(scene, rope_named(scene, "second"));
    EXPECT_NEAR(second.rope.damping, 0.25, 1e-15);
    EXPECT_EQ(second.model, Model::inextensible);
}

TEST(Problem, RefusesARopeThatIsNotThereAndADampingThatIsNoRate) {
    Scene scene = small_scene();
    EXPECT_THAT([&] { rope_named(scene, "third"); },
                testing::ThrowsMessage<std::runtime_error>(
                    "no rope 'third' in the scene; expected one of: 'first', 'second'"));
    scene.ropes[0].damping_factor = 1.0;
    EXPECT_THAT([&] { problem(scene, scene.ropes[0]); },
                testing::ThrowsMessage<std::runtime_error>(testing::HasSubstr("damping factor of 1")));
}

// The truth itself, moved by one tenth of a world unit in one frame, is off by a fifth of a pixel there.
TEST(MethodError, IsTheGreatestDistanceOnThePicture) {
    const Scene scene = small_scene();
    const Problem first = problem(scene, scene.ropes[0]);
    const Truth true_motion = truth(first);
    ASSERT_EQ(true_motion.frames, 11);
    EXPECT_LT(true_motion.error, 1e-10);
    std::vector<Points> frames = true_motion.reference.frames;
    frames[4].row(3) += Eigen::Array2d(0.06, 0.08).transpose();
    frames[10].row(2) += Eigen::Array2d(0.0, 0.05).transpose();
    const MethodError error = method_error(first, true_motion, frames);
    EXPECT_NEAR(error.worst, 0.2, 1e-12);
    EXPECT_NEAR(error.last, 0.1, 1e-12);
    EXPECT_EQ(error.of_frame[5], 0.0);
    frames.pop_back();
    EXPECT_TRUE(std::isinf(method_error(first, true_motion, frames).worst));
}

// Off by the square of the step: of order 2 about the truth that its damping factor stands for.
TEST(MethodError, FallsAtTheOrderOfTheMethod) {
    const Scene scene = small_scene();
    const Problem first = problem(scene, scene.ropes[0]);
    const Truth true_motion = truth(first);
    const Method& verlet = find_method("stormer_verlet");
    const double coarse = method_error(first, true_motion, simulate(first, verlet, 256).frames).worst;
    const double fine = method_error(first, true_motion, simulate(first, verlet, 512).frames).worst;
    EXPECT_NEAR(std::log2(coarse / fine), 2.0, 0.05);
}

}  // namespace
}  // namespace ropesim
