#include "simulation/chains.h"
#include "simulation/simulate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace ropesim {
namespace {

const Method& direct() {
    return find_method("direct_projection");
}

double worst_length(const Rope& rope, const Points& position) {
    double worst = 0.0;
    for (Eigen::Index i = 0; i + 1 < position.rows(); ++i) {
        const double length =
            std::hypot(position(i + 1, 0) - position(i, 0), position(i + 1, 1) - position(i, 1));
        worst = std::max(worst, std::abs(length / rope.rest_length - 1.0));
    }
    return worst;
}

TEST(DirectProjection, KeepsEveryLinkAtItsLength) {
    for (const std::vector<Eigen::Index>& pinned :
         {std::vector<Eigen::Index>{}, {0}, {7}, {0, 7}, {3, 4, 12}, {0, 15}}) {
        Rope rope = seed_rope(16);
        for (Eigen::Index i = 0; i < 15; ++i) {
            const double angle = 2.4 * std::sin(1.3 * static_cast<double>(i));
            rope.start(i + 1, 0) = rope.start(i, 0) + rope.rest_length * std::cos(angle);
            rope.start(i + 1, 1) = rope.start(i, 1) + rope.rest_length * std::sin(angle);
        }
        rope.pinned = pinned;
        rope.mass = Eigen::ArrayXd::LinSpaced(16, 0.01, 3.0);
        rope = finished(rope);
        for (const long frames : {1, 20, 60}) {
            const Points end = positions_at(rope, direct(), stepping(1.0, 64), frames);
            EXPECT_LT(worst_length(rope, end), 1e-13) << pinned.size() << " pins, frame " << frames;
            for (const Eigen::Index pin : pinned) EXPECT_TRUE((end.row(pin) == rope.start.row(pin)).all());
        }
    }
}

// A link that turns by more than a right angle in a step is beyond Newton's iteration. In halves of the step
// it is not, and the links keep their length all the same.
TEST(DirectProjection, TakesAStepThatIsTooLargeInHalves) {
    for (const int masses : {16, 128}) {
        for (const long steps : {1, 2, 3}) {
            const Rope rope = seed_rope(masses);
            const Trajectory motion = simulate(rope, direct(), stepping(1.0, steps), 60);
            EXPECT_FALSE(motion.diverged) << masses << " masses, " << steps << " steps";
            EXPECT_LT(worst_length(rope, motion.frames.back()), 1e-12);
        }
    }
}

// Pulled straight between two pins a rope has but one shape; the part beyond the pins swings all the same.
TEST(DirectProjection, HoldsWhatIsPulledStraightBetweenTwoPins) {
    Rope rope = seed_rope(9);
    rope.pinned = {0, 5};
    rope = finished(rope);
    const Points end = positions_at(rope, direct(), stepping(1.0, 64), 10);
    EXPECT_TRUE((end.topRows(6) == rope.start.topRows(6)).all());
    EXPECT_GT(std::abs(end(8, 1) - rope.start(8, 1)), 10.0);
    EXPECT_LT(worst_length(rope, end), 1e-13);
}

// Folded flat between two pins the constraints are dependent, too, but the rope can fall: four links over
// half their length, mirror-symmetric about the middle.
TEST(DirectProjection, UnfoldsFromALineBetweenTwoPins) {
    Rope rope = straight_rope(5, {1.0, 0.0}, {0.0, -1.0});
    rope.start << 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0;
    rope.pinned = {0, 4};
    rope = finished(rope);
    const Points end = positions_at(rope, direct(), stepping(1.0, 256), 2);
    ASSERT_TRUE(end.isFinite().all());
    EXPECT_LT(worst_length(rope, end), 1e-12);
    EXPECT_NEAR(end(1, 0), end(3, 0), 1e-9);
    EXPECT_NEAR(end(1, 1), end(3, 1), 1e-9);
    EXPECT_LT(end(2, 1), -0.1);
}

TEST(DirectProjection, RefusesARopeThatStartsStretched) {
    Rope rope = seed_rope(4);
    rope.rest_length = 100.0;
    rope = finished(rope);
    try {
        positions_at(rope, direct(), stepping(1.0, 64), 1);
        FAIL() << "accepted links of 133 for 100";
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(),
                     "direct_projection: link 0 is 133.333333 long at the start; expected its rest length, "
                     "100.000000");
    }
}

// One step of a hundred times the time that a link takes to fall its own length has no solution near by.
TEST(DirectProjection, DivergesRatherThanTakeABadStep) {
    const Trajectory trajectory = simulate(seed_rope(16), direct(), stepping(1000.0, 1), 20);
    EXPECT_TRUE(trajectory.diverged);
}

}  // namespace
}  // namespace ropesim
