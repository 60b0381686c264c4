#include "farm/clip_work.h"

#include <gtest/gtest.h>

namespace ropesim {
namespace {

// A thousand ropes of 64 masses, by Verlet.
Scene many(int steps_per_frame, int frames) {
    Scene scene;
    scene.frames = frames;
    scene.steps_per_frame = steps_per_frame;
    scene.ropes.resize(1000);
    for (SceneRope& rope : scene.ropes) {
        rope.method = "stormer_verlet";
        rope.end = {0.0, -150.0};
        rope.nodes = 64;
    }
    return scene;
}

// A step of Verlet is an evaluation for each mass, and one more at the start of a frame.
TEST(ClipWork, CountsSteps) {
    const ClipWork work = clip_work(many(64, 10));
    const double evaluations = 10.0 * 64.0 * 64'000.0;
    EXPECT_GE(work.simulating, evaluations);
    EXPECT_LE(work.simulating, 1.2 * evaluations);
    EXPECT_EQ(work.positions_bytes, 10.0 * 64'000.0 * 16.0);
}

TEST(ClipWork, IsWorthSimulatingOnceWhereThatDominates) {
    const ClipWork cheap = clip_work(many(1, 10));
    EXPECT_LT(cheap.simulating_share(8), 0.1);
    EXPECT_FALSE(worth_simulating_once(cheap, 8));
    const ClipWork dear = clip_work(many(1000, 10));
    EXPECT_GT(dear.simulating_share(8), 0.8);
    EXPECT_TRUE(worth_simulating_once(dear, 8));
    EXPECT_FALSE(worth_simulating_once(dear, 1));
    EXPECT_TRUE(worth_simulating_once(clip_work(many(1000, 10'000)), 8));    // 10 GB of positions
    EXPECT_FALSE(worth_simulating_once(clip_work(many(1000, 100'000)), 8));  // 100 GB
}

}  // namespace
}  // namespace ropesim
