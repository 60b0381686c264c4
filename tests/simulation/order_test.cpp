// Each row converges at its order, on both sides, to the solution of its own model.
#include "simulation/every_method.h"
#include "simulation/truth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace ropesim {
namespace {

struct OrderOf : testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Table, OrderOf, every_method(), row_name);

constexpr double time_of_comparison = 2.0;

// Five unequal masses in a zigzag of unit links.
Rope zigzag(std::vector<Eigen::Index> pinned, double damping) {
    Rope rope = straight_rope(5, {1.0, 0.0}, {0.25, -1.0});
    const double angles[4] = {-0.3, 0.5, -0.9, 0.2};
    for (Eigen::Index i = 0; i < 4; ++i) {
        rope.start(i + 1, 0) = rope.start(i, 0) + std::cos(angles[i]);
        rope.start(i + 1, 1) = rope.start(i, 1) + std::sin(angles[i]);
    }
    rope.mass << 1.0, 2.0, 0.5, 1.5, 1.0;
    rope.stiffness = 9.0;
    rope.pinned = std::move(pinned);
    rope.damping = damping;
    return finished(rope);
}

// What the method's positions converge to. The assignment's sweeps move unequal masses alike: theirs is the
// rope whose masses are equal.
Points limit(const Method& method, Rope rope) {
    if (method.name == "seed_constraints") rope.mass = 1.0;
    return truth(finished(rope), method.model, time_of_comparison, method.order == 6 ? 16384 : 2048);
}

// Springs start stretched, so that an unpinned rope does more than fall.
Rope for_model(const Method& method, Rope rope) {
    if (method.model == Model::elastic) rope.rest_length = 0.8;
    return finished(rope);
}

void expect_order(const Method& method, const std::vector<Eigen::Index>& pinned, double damping) {
    const Rope rope = for_model(method, zigzag(pinned, damping));
    const Points expected = limit(method, rope);
    const auto error = [&](long steps) {
        return greatest_distance(expected,
                                 positions_at(rope, method, stepping(time_of_comparison, steps), 1));
    };
    // Errors small enough to shrink evenly, and far enough above the truth's own.
    const long steps = method.order == 6 ? 32 : method.order == 4 ? 64 : method.order == 2 ? 256 : 4096;
    const int halvings = method.order == 6 ? 1 : 2;
    const double observed = std::log2(error(steps) / error(steps << halvings)) / halvings;
    EXPECT_NEAR(observed, method.order, 0.15) << "at " << steps << " steps off by " << error(steps);
}

TEST_P(OrderOf, OnePin) {
    expect_order(GetParam(), {0}, 0.0);
}

TEST_P(OrderOf, OnePinDamped) {
    expect_order(GetParam(), {0}, 0.3);
}

TEST_P(OrderOf, TwoPins) {
    expect_order(GetParam(), {0, 4}, 0.0);
}

TEST_P(OrderOf, TwoPinsDamped) {
    expect_order(GetParam(), {4, 0}, 0.3);
}

TEST_P(OrderOf, APinInTheMiddle) {
    expect_order(GetParam(), {2}, 0.0);
}

// An unpinned inextensible rope falls from rest as a single mass does, which FallsFreely covers; damped, too,
// but there the order is to be seen.
TEST_P(OrderOf, NoPin) {
    if (GetParam().model == Model::elastic) expect_order(GetParam(), {}, 0.0);
}

TEST_P(OrderOf, NoPinDamped) {
    expect_order(GetParam(), {}, 0.3);
}

// The two truths agree where they must: stiffness makes a spring a rod, with an error of 1/k.
TEST(Truth, OfStiffSpringsApproachesThatOfRods) {
    Rope rope = zigzag({0}, 0.0);
    const Points rods = truth(rope, Model::inextensible, 1.0, 1024);
    rope.stiffness = 1e4;
    const double soft = greatest_distance(rods, truth(rope, Model::elastic, 1.0, 4096));
    rope.stiffness = 4e4;
    const double stiff = greatest_distance(rods, truth(rope, Model::elastic, 1.0, 8192));
    EXPECT_LT(soft, 0.01);
    EXPECT_LT(stiff, 0.5 * soft);
}

TEST(Truth, IsConverged) {
    for (const Model model : {Model::elastic, Model::inextensible}) {
        const Rope rope = zigzag({0, 4}, 0.3);
        EXPECT_LT(greatest_distance(truth(rope, model, time_of_comparison, 2048),
                                    truth(rope, model, time_of_comparison, 4096)),
                  2e-11);
    }
}

}  // namespace
}  // namespace ropesim
