// How far the methods are from the truth on the assignment's rope of 16 masses, in pixels.
#include "simulation/chains.h"
#include "simulation/truth.h"

#include <gtest/gtest.h>

#include <string>

namespace ropesim {
namespace {

double error(const char* method, long steps, const Points& expected) {
    return greatest_distance(expected,
                             positions_at(seed_rope(16), find_method(method), stepping(1.0, steps), 20));
}

TEST(Accuracy, OfTheElasticMethodsAtFrame20) {
    const Points expected = truth(seed_rope(16), Model::elastic, 20.0, 512);
    EXPECT_LT(error("symplectic_euler", 64, expected), 0.2);
    EXPECT_LT(error("stormer_verlet", 64, expected), 0.0002);
    EXPECT_LT(error("implicit_midpoint", 64, expected), 0.0003);
    EXPECT_LT(error("runge_kutta_4", 64, expected), 2e-7);
    EXPECT_LT(error("blanes_moan_4", 4, expected), 0.0001);
    EXPECT_LT(error("blanes_moan_4", 16, expected), 1e-7);
    EXPECT_LT(error("blanes_moan_4", 64, expected), 1e-9);
    EXPECT_LT(error("blanes_moan_4", 4096, expected), 1e-9);
}

TEST(Accuracy, OfTheInextensibleMethodsAtFrame20) {
    const Points expected = truth(seed_rope(16), Model::inextensible, 20.0, 64);
    EXPECT_LT(error("direct_projection", 64, expected), 0.00015);
    EXPECT_LT(error("direct_projection", 1024, expected), 0.00015 / 250.0);
    EXPECT_LT(error("constraint_projection", 64, expected), 0.2);
}

// As k goes to infinity, springs become rods. Seven steps of zigzag, at steps that no spring's period limits.
Rope stiff_zigzag(double stiffness) {
    Rope rope = straight_rope(5, {1.0, 0.0}, {0.25, -1.0});
    rope.start << 0.0, 0.0, 0.8, -0.6, 1.6, 0.0, 2.4, 0.6, 3.2, 0.0;
    rope.mass << 1.0, 2.0, 0.5, 1.5, 1.0;
    rope.stiffness = stiffness;
    return finished(rope);
}

class Stiff : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Table, Stiff, testing::Values("xpbd", "backward_euler", "implicit_midpoint"),
                         [](const auto& row) { return std::string(row.param); });

TEST_P(Stiff, SpringsMoveAsRods) {
    const Rope rope = stiff_zigzag(1e10);
    const Points rods = truth(rope, Model::inextensible, 2.0, 1024);
    const auto off = [&](long steps) {
        return greatest_distance(rods, positions_at(rope, find_method(GetParam()), stepping(2.0, steps), 1));
    };
    EXPECT_LT(off(512), 0.02);
    EXPECT_LT(off(2048), 0.3 * off(512));
    EXPECT_LT(
        greatest_distance(rods, positions_at(rope, find_method("direct_projection"), stepping(2.0, 2048), 1)),
        1e-6);
}

TEST(Xpbd, OfInfiniteStiffnessIsConstraintProjection) {
    const Rope rope = stiff_zigzag(1e16);
    EXPECT_LT(
        greatest_distance(positions_at(rope, find_method("constraint_projection"), stepping(2.0, 256), 1),
                          positions_at(rope, find_method("xpbd"), stepping(2.0, 256), 1)),
        1e-8);
}

TEST(Xpbd, SweptManyTimesIsNearerToBackwardEulersLength) {
    const Rope rope = stiff_zigzag(1e4);
    const Points implicit = positions_at(rope, find_method("backward_euler"), stepping(1.0, 64), 1);
    Stepping swept = stepping(1.0, 64);
    const double once = greatest_distance(implicit, positions_at(rope, find_method("xpbd"), swept, 1));
    swept.sweeps = 200;
    const double often = greatest_distance(implicit, positions_at(rope, find_method("xpbd"), swept, 1));
    EXPECT_LT(often, 0.5 * once);
}

}  // namespace
}  // namespace ropesim
