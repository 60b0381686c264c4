// The fast form of a method gives the very bits of its plain form, by every instruction set of this machine.
#include "simulation/instruction_set.h"

#include "simulation/chains.h"
#include "simulation/leaps.h"
#include "simulation/links.h"
#include "simulation/plain_methods.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <string>
#include <vector>

namespace ropesim {
namespace {

bool same_bits(const Points& a, const Points& b) {
    return a.rows() == b.rows() &&
           std::memcmp(a.data(), b.data(), static_cast<std::size_t>(a.size()) * sizeof(double)) == 0;
}

// A bent, moving rope of unequal masses, two of which are in one place, pinned here and there.
Rope bent_rope(int masses, double stiffness) {
    Rope rope = straight_rope(masses, {1.0, 0.0}, {0.25, -1.0});
    for (int i = 0; i < masses; ++i) {
        rope.start.row(i) << std::sin(0.7 * i) - 0.5 * i, -0.0 + std::cos(1.9 * i);
        rope.mass(i) = 1.0 + 0.25 * (i % 5);
    }
    if (masses > 4) rope.start.row(3) = rope.start.row(2);
    rope.pinned = {0};
    if (masses > 9) rope.pinned = {8, masses - 1};
    rope.stiffness = stiffness;
    return finished(rope);
}

State moving(const Rope& rope) {
    State state = at_rest(rope);
    for (Eigen::Index i = 0; i < rope.start.rows(); ++i)
        if (rope.inverse_mass(i) > 0.0)
            state.velocity.row(i) << 0.3 * std::cos(static_cast<double>(i)), -0.25;
    return state;
}

struct Damping {
    double rate;
    double factor;
};

// Lengths about those of one vector, several, two blocks of the cache (by what a method keeps for each mass)
// and more; steps about those that go through the cache at once.
struct Case {
    int masses;
    long steps;
};
constexpr Case cases[] = {{2, 3},   {3, 5},     {7, 9},   {8, 9},     {9, 9},     {10, 1},
                          {11, 7},  {15, 64},   {16, 65}, {17, 64},   {20, 2},    {21, 7},
                          {31, 10}, {33, 10},   {40, 4},  {41, 7},    {48, 65},   {49, 1},
                          {64, 11}, {100, 130}, {448, 9}, {449, 9},   {512, 9},   {513, 40},
                          {704, 9}, {705, 9},   {717, 9}, {1025, 64}, {1025, 65}, {2500, 70}};

class EachInstructionSet : public testing::TestWithParam<InstructionSet> {};
INSTANTIATE_TEST_SUITE_P(OfThisMachine, EachInstructionSet,
                         testing::ValuesIn(instruction_sets().begin(), instruction_sets().end()),
                         [](const auto& row) {
                             return row.param == InstructionSet::avx512 ? "Avx512"
                                                                        : std::string(name(row.param));
                         });

TEST_P(EachInstructionSet, GivesTheBitsOfThePlainForm) {
    for (const std::string_view method : plain_methods)
        for (const Damping damping : {Damping{0.0, 0.0}, {0.1, 0.0}, {0.05, 0.001}})
            for (const Case each : cases) {
                Rope rope = bent_rope(each.masses, 9.0);
                rope.damping = damping.rate;
                Stepping steps = stepping(1.0, each.steps);
                steps.damping_factor = damping.factor;
                State expected = moving(rope);
                State actual = expected;
                Scratch scratch;
                scratch.instructions = GetParam();
                for (int frame = 0; frame < 2; ++frame) {
                    advance_plainly(method, rope, steps, expected);
                    find_method(method).advance(rope, steps, actual, scratch);
                }
                EXPECT_TRUE(same_bits(expected.position, actual.position) &&
                            same_bits(expected.velocity, actual.velocity))
                    << method << ", " << each.masses << " masses, " << each.steps << " steps, damping "
                    << damping.rate << " and " << damping.factor;
            }
}

TEST_P(EachInstructionSet, GivesTheSameAccelerations) {
    for (const Case each : cases) {
        const Rope rope = bent_rope(each.masses, 9.0);
        Scratch scratch;
        scratch.instructions = GetParam();
        accelerations(rope, rope.start, scratch);
        EXPECT_TRUE(same_bits(plain_accelerations(rope, rope.start), scratch.acceleration)) << each.masses;
    }
}

// A rope of links that keep their length, by the widest instructions and by two lanes.
TEST_P(EachInstructionSet, ProjectsToTheSameBits) {
    const Method& method = find_method("direct_projection");
    for (const int masses : {2, 3, 4, 9, 16, 33, 64, 100}) {
        Rope rope = straight_rope(masses, {1.0, 0.0}, {0.25, -1.0});
        for (int i = 0; i < masses; ++i) rope.mass(i) = 1.0 + 0.25 * (i % 5);
        rope = finished(rope);
        State expected = at_rest(rope);
        State actual = expected;
        Scratch two_lanes, scratch;
        two_lanes.instructions = InstructionSet::baseline;
        scratch.instructions = GetParam();
        for (int frame = 0; frame < 5; ++frame) {
            method.advance(rope, stepping(1.0, 8), expected, two_lanes);
            method.advance(rope, stepping(1.0, 8), actual, scratch);
        }
        EXPECT_TRUE(same_bits(expected.position, actual.position)) << masses;
        EXPECT_TRUE(same_bits(expected.velocity, actual.velocity)) << masses;
        EXPECT_TRUE(expected.position.isFinite().all()) << masses;
    }
}

// Ropes of one length that have nothing else in common; one is so stiff that it blows up, beside the others.
std::vector<Rope> unlike_ropes(int masses, int count) {
    std::vector<Rope> ropes;
    for (int r = 0; r < count; ++r) {
        ropes.push_back(bent_rope(masses, r == 1 ? 1e9 : 3.0 + r));
        ropes.back().rest_length = 0.5 + 0.125 * r;
        ropes.back().gravity = {0.1 * r, -1.0};
        ropes.back() = finished(ropes.back());
    }
    return ropes;
}

void expect_the_plain_bits_side_by_side(std::string_view method, const std::vector<Rope>& ropes,
                                        InstructionSet instructions) {
    const Stepping steps = stepping(1.0, 20);
    const Leaps leaps = find_method(method).leaps(ropes.front(), steps);
    Bundle bundle;
    bundle.resize(ropes.front().start.rows(), lanes(instructions), fields(leaps));
    for (std::size_t r = 0; r < ropes.size(); ++r) {
        bundle.put(ropes[r], static_cast<Eigen::Index>(r));
        bundle.put(moving(ropes[r]), static_cast<Eigen::Index>(r), leaps.velocity_unit);
    }
    Cost cost;
    leap(leaps, bundle, instructions, cost);
    for (std::size_t r = 0; r < ropes.size(); ++r) {
        State expected = moving(ropes[r]);
        State actual = expected;
        advance_plainly(method, ropes[r], steps, expected);
        bundle.take(actual, static_cast<Eigen::Index>(r), leaps.velocity_unit);
        EXPECT_TRUE(same_bits(expected.position, actual.position)) << method << ", rope " << r;
        EXPECT_TRUE(same_bits(expected.velocity, actual.velocity)) << method << ", rope " << r;
    }
}

TEST_P(EachInstructionSet, GivesTheBitsOfThePlainFormSideBySide) {
    const int width = lanes(GetParam());
    for (const std::string_view method : plain_methods)
        for (const int masses : {2, 3, 4, 5, 16, 40, 64, 65, 88, 89, 178, 179, 200})
            for (const int count : {width, width - 1})
                if (find_method(method).leaps)
                    expect_the_plain_bits_side_by_side(method, unlike_ropes(masses, count), GetParam());
}

}  // namespace
}  // namespace ropesim
