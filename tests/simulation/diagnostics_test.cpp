#include "simulation/diagnostics.h"

#include "simulation/chains.h"

#include <gtest/gtest.h>
#include <Eigen/Eigenvalues>

#include <cmath>
#include <numbers>

namespace ropesim {
namespace {

// One free mass at (3, 4), moving at (1, 2): by hand.
TEST(Energy, IsKineticAndSpringAndGravity) {
    Rope rope = straight_rope(2, {1.0, 0.0}, {0.0, -2.0});
    rope.mass(1) = 4.0;
    rope = finished(rope);
    State state = at_rest(rope);
    state.position.row(1) << 3.0, 4.0;
    state.velocity.row(1) << 1.0, 2.0;
    const Energy elastic = energy(rope, Model::elastic, state);
    EXPECT_DOUBLE_EQ(elastic.kinetic, 10.0);
    EXPECT_DOUBLE_EQ(elastic.spring, 800.0);
    EXPECT_DOUBLE_EQ(elastic.gravity, 32.0);
    EXPECT_EQ(energy(rope, Model::inextensible, state).spring, 0.0);
}

// n free masses behind one pin: ω = 2 sqrt(k/m) cos(π / (2n + 1)); free of pins: 2 sqrt(k/m) cos(π / (2n)).
TEST(GreatestFrequency, OfAUniformChainIsKnown) {
    for (const int masses : {2, 3, 16, 1000}) {
        Rope rope = straight_rope(masses, {0.0, 1.0}, {0.0, 0.0});
        const double bound = 2.0 * std::sqrt(rope.stiffness);
        EXPECT_NEAR(greatest_frequency(rope), bound * std::cos(std::numbers::pi / (2 * masses - 1)), 1e-11);
        rope.pinned = {};
        EXPECT_NEAR(greatest_frequency(finished(rope)), bound * std::cos(std::numbers::pi / (2 * masses)),
                    1e-11);
    }
}

TEST(GreatestFrequency, OfAnUnevenChainIsItsLargestEigenvalue) {
    Rope rope = straight_rope(40, {1.0, 0.0}, {0.0, 0.0});
    for (int i = 0; i < 40; ++i) rope.mass(i) = 0.1 + std::abs(std::sin(12.9898 * i)) * 7.0;
    rope.pinned = {0, 17, 39};
    rope = finished(rope);
    Eigen::MatrixXd links = Eigen::MatrixXd::Zero(39, 39);
    for (int i = 0; i < 39; ++i) {
        links(i, i) = rope.inverse_mass(i) + rope.inverse_mass(i + 1);
        if (i > 0) links(i, i - 1) = links(i - 1, i) = -rope.inverse_mass(i);
    }
    const double largest = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(links).eigenvalues().maxCoeff();
    EXPECT_NEAR(greatest_frequency(rope), std::sqrt(100.0 * largest), 1e-11);
}

TEST(GreatestFrequency, IsZeroWhereNothingCanSwing) {
    Rope rope = straight_rope(3, {1.0, 0.0}, {0.0, 0.0});
    rope.pinned = {0, 1, 2};
    EXPECT_EQ(greatest_frequency(finished(rope)), 0.0);
}

// A conical pendulum in the plane: a chain swinging through its lowest point turns as one, at rate ω about
// the pin; link i carries the weight below it and m ω² r of each mass below it.
TEST(Tensions, OfARopeThatSwingsAsOne) {
    Rope rope = straight_rope(4, {0.0, -1.0}, {0.0, -1.5});
    rope.mass << 1.0, 2.0, 0.5, 3.0;
    rope = finished(rope);
    State state = at_rest(rope);
    const double omega = 0.8;
    for (int i = 0; i < 4; ++i) state.velocity(i, 0) = omega * i;
    const Eigen::ArrayXd tension = tensions(rope, Model::inextensible, state);
    double expected = 0.0;
    for (int i = 3; i >= 1; --i) {
        expected += rope.mass(i) * (1.5 + omega * omega * i);
        EXPECT_NEAR(tension(i - 1), expected, 1e-13) << i;
    }
}

// Two links, pinned at both ends, sagging by 3-4-5: the middle carries its weight by 2 T 4/5.
TEST(Tensions, OfARopeHeldAtBothEnds) {
    Rope rope = straight_rope(3, {1.0, 0.0}, {0.0, -2.0});
    rope.start << 0.0, 0.0, 0.6, -0.8, 1.2, 0.0;
    rope.pinned = {0, 2};
    rope = finished(rope);
    const Eigen::ArrayXd tension = tensions(rope, Model::inextensible, at_rest(rope));
    EXPECT_NEAR(tension(0), 1.25, 1e-14);
    EXPECT_NEAR(tension(1), 1.25, 1e-14);
}

TEST(Tensions, OfSpringsFollowHookesLaw) {
    Rope rope = straight_rope(3, {1.0, 0.0}, {0.0, -2.0});
    rope.start << 0.0, 0.0, 1.5, 0.0, 1.5, 0.25;
    const Eigen::ArrayXd tension = tensions(finished(rope), Model::elastic, at_rest(rope));
    EXPECT_DOUBLE_EQ(tension(0), 50.0);
    EXPECT_DOUBLE_EQ(tension(1), -75.0);
    const Diagnostics all = diagnostics(rope, Model::elastic, at_rest(rope));
    EXPECT_DOUBLE_EQ(all.largest_tension, 50.0);
    EXPECT_DOUBLE_EQ(all.largest_stretch, 0.5);
    EXPECT_DOUBLE_EQ(all.length, 1.75);
}

TEST(LongestLink, IsTheLongest) {
    Points position(4, 2);
    position << 0.0, 0.0, 1.0, 0.0, 4.0, 4.0, 4.0, 6.0;
    EXPECT_EQ(longest_link(position), 5.0);
}

}  // namespace
}  // namespace ropesim
