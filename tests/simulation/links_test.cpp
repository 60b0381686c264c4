#include "simulation/links.h"

#include "simulation/chains.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ropesim {
namespace {

Points accelerations_of(const Rope& rope, const Points& position) {
    Scratch scratch;
    accelerations(rope, position, scratch);
    return scratch.acceleration;
}

// One spring, stretched along 3-4-5: tension k (5 - 1) = 400 along (3, 4)/5.
TEST(Accelerations, FollowHookesLaw) {
    Rope rope = straight_rope(2, {1.0, 0.0}, {0.0, -1.0});
    rope.mass(1) = 2.0;
    rope = finished(rope);
    Points position(2, 2);
    position << 0.0, 0.0, 3.0, 4.0;
    const Points acceleration = accelerations_of(rope, position);
    EXPECT_EQ(acceleration(0, 0), 0.0);
    EXPECT_EQ(acceleration(0, 1), 0.0);
    EXPECT_NEAR(acceleration(1, 0), -400.0 * 0.6 / 2.0, 1e-12);
    EXPECT_NEAR(acceleration(1, 1), -400.0 * 0.8 / 2.0 - 1.0, 1e-12);
}

// Forces between masses cancel in pairs, whatever the shape.
TEST(Accelerations, OfAnUnpinnedRopeChangeNoMomentum) {
    Rope rope = straight_rope(9, {1.0, 0.0}, {0.0, 0.0});
    rope.pinned = {};
    rope.mass = Eigen::ArrayXd::LinSpaced(9, 0.5, 4.5);
    rope = finished(rope);
    Points position = rope.start;
    for (int i = 0; i < 9; ++i) position.row(i) << 3.0 * std::cos(1.7 * i), 2.0 * std::sin(2.9 * i);
    const Points acceleration = accelerations_of(rope, position);
    const double scale = (rope.mass * acceleration.col(0)).abs().sum();
    EXPECT_NEAR((rope.mass * acceleration.col(0)).sum(), 0.0, 1e-14 * scale);
    EXPECT_NEAR((rope.mass * acceleration.col(1)).sum(), 0.0, 1e-14 * scale);
}

TEST(Accelerations, OfALinkWithoutLengthAreGravityAlone) {
    Rope rope = straight_rope(2, {1.0, 0.0}, {0.25, -1.0});
    const Points acceleration = accelerations_of(rope, Points::Zero(2, 2));
    EXPECT_EQ(acceleration(1, 0), 0.25);
    EXPECT_EQ(acceleration(1, 1), -1.0);
}

TEST(PullToRestLength, SharesTheExcess) {
    Points position(2, 2);
    position << 0.0, 0.0, 0.0, 5.0;
    Points moved = Points::Zero(2, 2);
    moved(1, 1) = 4.0;  // 9 long by now
    pull_to_rest_length(position, moved, 0, 1.0, 0.25, 0.75);
    EXPECT_NEAR(moved(0, 1), 2.0, 1e-15);
    EXPECT_NEAR(moved(1, 1), 4.0 - 6.0, 1e-15);
}

TEST(Decay, IsTheExponential) {
    EXPECT_EQ(decay(0.0), 1.0);
    for (double x = 1e-12; x < 600.0; x *= 1.37)
        EXPECT_NEAR(decay(x) / std::exp(-x), 1.0, 4e-16 * (1.0 + 16.0 * x))
            << x;  // squaring doubles rounding
    EXPECT_EQ(decay(1e9), 0.0);
    for (double x = 1e-12; x < 10.0; x *= 1.37)
        EXPECT_NEAR(decay(-x) / std::exp(x), 1.0, 4e-16 * (1.0 + 16.0 * x)) << x;
}

TEST(MeanDecay, IsTheMeanOfTheExponential) {
    EXPECT_EQ(mean_decay(0.0), 1.0);
    for (double x = 1e-12; x < 600.0; x *= 1.37) {
        EXPECT_NEAR(mean_decay(x) * x / -std::expm1(-x), 1.0, 4e-15) << x;
    }
    for (double x = 1e-12; x < 10.0; x *= 1.37)
        EXPECT_NEAR(mean_decay(-x) * x / std::expm1(x), 1.0, 4e-16 * (2.0 + 16.0 * x)) << x;
    EXPECT_EQ(mean_decay(INFINITY), 0.0);
}

// What is left after the exponent is what the rate and the factor leave.
TEST(DampingPerStep, IsTheLogarithmOfWhatIsLost) {
    Rope rope = straight_rope(2, {1.0, 0.0}, {0.0, 0.0});
    rope.damping = 0.25;
    for (const double factor : {0.0, 1e-9, 0.00005, 0.1, 0.5, 0.999, 1.0 - 1e-12})
        EXPECT_NEAR(damping_per_step(rope, {.step_size = 0.5, .damping_factor = factor}),
                    0.125 - std::log1p(-factor), 1e-15 * (1.0 - 16.0 * std::log1p(-factor)))
            << factor;
}

}  // namespace
}  // namespace ropesim
