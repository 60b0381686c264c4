#include "simulation/implicit_springs.h"

#include "simulation/chains.h"
#include "simulation/plain_methods.h"
#include "simulation/simulate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace ropesim {
namespace {

// Five unequal masses in a zigzag, on springs, damped.
Rope zigzag() {
    Rope rope = straight_rope(5, {1.0, 0.0}, {0.25, -1.0});
    rope.start << 0.0, 0.0, 0.8, -0.6, 1.6, 0.0, 2.4, 0.6, 3.2, 0.0;
    rope.mass << 1.0, 2.0, 0.5, 1.5, 1.0;
    rope.stiffness = 9.0;
    rope.rest_length = 0.8;
    rope.damping = 0.3;
    return finished(rope);
}

constexpr double h = 0.25;

// A step from where the rope is after three.
struct Step {
    State before;
    State after;
};
Step fourth_step(const Rope& rope, const char* method) {
    State state = at_rest(rope);
    Scratch scratch;
    find_method(method).advance(rope, {.steps = 3, .step_size = h}, state, scratch);
    Step step{state, state};
    find_method(method).advance(rope, {.steps = 1, .step_size = h}, step.after, scratch);
    return step;
}

TEST(BackwardEuler, SolvesItsEquation) {
    const Rope rope = zigzag();
    const auto [before, after] = fourth_step(rope, "backward_euler");
    const Points velocity =
        std::exp(-rope.damping * h) * before.velocity + h * plain_accelerations(rope, after.position);
    EXPECT_LT(greatest_distance(velocity, after.velocity), 1e-13);
    EXPECT_LT(greatest_distance(before.position + h * velocity, after.position), 1e-13);
}

TEST(ImplicitMidpoint, SolvesItsEquation) {
    const Rope rope = zigzag();
    const auto [before, after] = fourth_step(rope, "implicit_midpoint");
    const double kept_half = std::exp(-rope.damping * h / 2.0);
    const Points middle = 0.5 * (before.position + after.position);
    const Points first = kept_half * before.velocity;
    const Points last = first + h * plain_accelerations(rope, middle);
    EXPECT_LT(greatest_distance(kept_half * last, after.velocity), 1e-13);
    EXPECT_LT(greatest_distance(before.position + h / 2.0 * (first + last), after.position), 1e-13);
}

// The derivative of Hooke's force by differences, of a stretched link and of a compressed one.
TEST(LinkStiffness, IsTheDerivativeOfTheForce) {
    const Rope rope = zigzag();
    const auto force = [&](double x, double y) {
        const double pull = rope.stiffness * (1.0 - rope.rest_length / std::hypot(x, y));
        return Eigen::Array2d(pull * x, pull * y);
    };
    for (const double length : {0.3, 2.0}) {
        const double x = 0.6 * length, y = -0.8 * length, d = 1e-5;
        const Eigen::Array3d stiffness = link_stiffness(rope, x, y, false);
        const Eigen::Array2d by_x = (force(x + d, y) - force(x - d, y)) / (2.0 * d);
        const Eigen::Array2d by_y = (force(x, y + d) - force(x, y - d)) / (2.0 * d);
        EXPECT_NEAR(stiffness(0), by_x.x(), 1e-7);
        EXPECT_NEAR(stiffness(1), by_x.y(), 1e-7);
        EXPECT_NEAR(stiffness(1), by_y.x(), 1e-7);
        EXPECT_NEAR(stiffness(2), by_y.y(), 1e-7);
    }
}

// Without compression a link has the stiffness k along itself, and none across where it is compressed.
TEST(LinkStiffness, CanLeaveOutWhatCompressionMakesNegative) {
    const Rope rope = zigzag();
    EXPECT_NEAR(link_stiffness(rope, 0.0, 0.3, false)(0), rope.stiffness * (1.0 - 0.8 / 0.3), 1e-12);
    EXPECT_EQ(link_stiffness(rope, 0.0, 0.3, true)(0), 0.0);
    EXPECT_NEAR(link_stiffness(rope, 0.0, 0.3, true)(2), rope.stiffness, 1e-12);
    EXPECT_TRUE((link_stiffness(rope, 0.6, 1.6, true) == link_stiffness(rope, 0.6, 1.6, false)).all());
}

class Implicit : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Table, Implicit, testing::Values("backward_euler", "implicit_midpoint"),
                         [](const auto& row) { return std::string(row.param); });

// The rope packed into a share of its length: `turn` from link to link, and so straight, folded onto itself,
// or curled. Its springs shoot it apart, over steps that have nothing to do with their periods.
Rope packed(int masses, double share, double turn, double stiffness) {
    Rope rope = straight_rope(masses, {1.0, 0.0}, {0.0, -1.0});
    double angle = 0.1;
    for (int i = 1; i < masses; ++i, angle += turn)
        rope.start.row(i) << rope.start(i - 1, 0) + share * std::cos(angle),
            rope.start(i - 1, 1) + share * std::sin(angle);
    rope.stiffness = stiffness;
    return finished(rope);
}

TEST_P(Implicit, FindsEveryStepOfACrumpledRope) {
    for (const int masses : {3, 6, 28})
        for (const double share : {1.0, 0.1, 1e-3, 1e-6})
            for (const double turn : {0.0, 0.3, 2.0, std::numbers::pi})
                for (const double stiffness : {10.0, 1e6}) {
                    const Rope rope = packed(masses, share, turn, stiffness);
                    for (const long steps : {1, 11})
                        EXPECT_FALSE(
                            simulate(rope, find_method(GetParam()), stepping(1.0, steps), 30).diverged)
                            << masses << " masses, " << share << " of the length, turn " << turn << ", k "
                            << stiffness << ", " << steps << " steps";
                }
}

// Springs much longer than their rest length pull the rope through itself, and its links through no length.
TEST_P(Implicit, FindsEveryStepOfARopeThatSnapsTogether) {
    for (const double share : {5.0, 20.0, 100.0})
        for (const double stiffness : {10.0, 1e3, 1e5}) {
            const Rope rope = packed(9, share, std::numbers::pi / 2.0, stiffness);
            for (const long steps : {8, 34})
                EXPECT_FALSE(simulate(rope, find_method(GetParam()), stepping(1.0, steps), 30).diverged)
                    << share << " times the length, k " << stiffness << ", " << steps << " steps";
        }
}

}  // namespace
}  // namespace ropesim
