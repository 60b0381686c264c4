#include "simulation/moving_ropes.h"

#include "simulation/chains.h"
#include "simulation/every_method.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

namespace ropesim {
namespace {

struct ManyRopes : testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Table, ManyRopes, every_method(), row_name);

// As many as fill some vectors and a part of one, every fourth of another length, one too stiff for the
// steps.
std::vector<Rope> unlike_ropes() {
    std::vector<Rope> ropes;
    for (int r = 0; r < 28; ++r) {
        ropes.push_back(seed_rope(r % 4 == 3 ? 5 : 12));
        ropes.back().stiffness = r == 5 ? 1e6 : 100.0 + r;
        ropes.back().gravity = {0.01 * r, -1.0};
        ropes.back().damping = r < 24 ? 0.0 : 0.01;
        ropes.back() = finished(ropes.back());
    }
    return ropes;
}

bool same_bits(const Points& a, const Points& b) {
    return std::memcmp(a.data(), b.data(), static_cast<std::size_t>(a.size()) * sizeof(double)) == 0;
}

void expect_same(const MovingRope& alone, const MovingRope& together) {
    EXPECT_EQ(alone.diverged(), together.diverged());
    EXPECT_EQ(alone.state().time, together.state().time);
    EXPECT_EQ(alone.cost().evaluations, together.cost().evaluations);
    EXPECT_EQ(alone.cost().solves, together.cost().solves);
    EXPECT_TRUE(same_bits(alone.state().position, together.state().position));
    EXPECT_TRUE(same_bits(alone.state().velocity, together.state().velocity));
}

TEST_P(ManyRopes, MoveAsEachDoesAlone) {
    const std::vector<Rope> ropes = unlike_ropes();
    std::vector<MovingRope> alone;
    for (const Rope& rope : ropes) alone.emplace_back(rope, GetParam(), stepping(1.0, 32));
    MovingRopes together(alone);
    for (int frame = 1; frame < 8; ++frame) {
        together.advance();
        for (std::size_t r = 0; r < ropes.size(); ++r) {
            SCOPED_TRACE("rope " + std::to_string(r) + ", frame " + std::to_string(frame));
            alone[r].advance();
            expect_same(alone[r], together[r]);
        }
    }
}

TEST(MovingRopes, MayBeNone) {
    MovingRopes none({});
    none.advance();
    EXPECT_EQ(none.size(), 0u);
}

}  // namespace
}  // namespace ropesim
