// What of an error is rounding, and what is exact but for it.
#include "simulation/every_method.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <string>

namespace ropesim {
namespace {

struct Rounding : testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Table, Rounding, every_method(), row_name);

Points turned(const Points& points) {
    Points result(points.rows(), 2);
    result.col(0) = 0.6 * points.col(0) - 0.8 * points.col(1);
    result.col(1) = 0.8 * points.col(0) + 0.6 * points.col(1);
    return result;
}

// The seed's rope at 4096 steps per frame and, turned by 3-4-5, the same rope again: the rule is the same,
// no rounding is, so that what lies between them at frame 20 is what rounding did, at both.
TEST_P(Rounding, StaysBelowAHundredMillionthOfAPixel) {
    const Rope rope = seed_rope(16);
    Rope other = rope;
    other.start = turned(rope.start);
    other.gravity = {0.8, -0.6};
    other = finished(other);
    const Points expected = turned(positions_at(rope, GetParam(), stepping(1.0, 4096), 20));
    const Points actual = positions_at(other, GetParam(), stepping(1.0, 4096), 20);
    const double floor = greatest_distance(expected, actual);
    std::printf("%-22s %.2g px\n", std::string(GetParam().name).c_str(), floor);
    EXPECT_LT(floor, 1e-8);
    EXPECT_GT(floor, 0.0);
}

// A rope that flies as a whole, with no force on it, goes straight, but for the rounding of the places: up to
// 9600 drifts, each by 3e-14 at most, of which many go the same way.
TEST_P(Rounding, LeavesATranslationExact) {
    Rope rope = seed_rope(6);
    rope.pinned = {};
    rope.gravity = {0.0, 0.0};
    rope = finished(rope);
    State state = at_rest(rope);
    state.velocity.col(0) = 3.0;
    state.velocity.col(1) = -0.7;
    Scratch scratch;
    for (int frame = 0; frame < 10; ++frame) GetParam().advance(rope, stepping(1.0, 64), state, scratch);
    for (Eigen::Index i = 0; i < 6; ++i) {
        EXPECT_NEAR(state.position(i, 0), rope.start(i, 0) + 30.0, 1e-10);
        EXPECT_NEAR(state.position(i, 1), rope.start(i, 1) - 7.0, 1e-10);
    }
}

}  // namespace
}  // namespace ropesim
