#include "simulation/simulate.h"

#include "simulation/chains.h"

#include <gtest/gtest.h>

namespace ropesim {
namespace {

TEST(Simulate, BeginsAtTheStart) {
    const Rope rope = seed_rope(16);
    const Trajectory trajectory = simulate(rope, find_method("stormer_verlet"), stepping(1.0, 64), 3);
    ASSERT_EQ(trajectory.frames.size(), 3u);
    EXPECT_TRUE((trajectory.frames[0] == rope.start).all());
    EXPECT_FALSE(trajectory.diverged);
}

TEST(Simulate, GivesTheSameBitsForAnyNumberOfFrames) {
    const Rope rope = seed_rope(16);
    const Method& method = find_method("seed_verlet");
    const Trajectory few = simulate(rope, method, stepping(1.0, 48), 7);
    const Trajectory many = simulate(rope, method, stepping(1.0, 48), 50);
    for (std::size_t frame = 0; frame < few.frames.size(); ++frame)
        EXPECT_TRUE((few.frames[frame] == many.frames[frame]).all());
}

TEST(Simulate, EndsWhereTheRopeDivergesAndKeepsNothingNonFinite) {
    for (const long steps : {1, 2, 8, 64}) {
        const Trajectory trajectory =
            simulate(seed_rope(16), find_method("explicit_euler"), stepping(1.0, steps), 400);
        ASSERT_TRUE(trajectory.diverged) << steps;
        EXPECT_EQ(trajectory.frames.size(), static_cast<std::size_t>(*trajectory.diverged));
        for (const Points& points : trajectory.frames) EXPECT_TRUE(points.isFinite().all());
        EXPECT_TRUE(std::isfinite(trajectory.summary.energy_drift()) &&
                    std::isfinite(trajectory.summary.largest_stretch));
    }
}

// Störmer-Verlet starts every frame anew: one evaluation more than its steps.
TEST(Simulate, CountsWhatItComputes) {
    EXPECT_EQ(simulate(seed_rope(16), find_method("stormer_verlet"), stepping(1.0, 64), 11).cost.evaluations,
              10 * 65);
    Stepping swept = stepping(1.0, 64);
    swept.sweeps = 3;
    EXPECT_EQ(simulate(seed_rope(16), find_method("constraint_projection"), swept, 11).cost.solves,
              10 * 64 * 3);
}

// A rope without springs falls apart; that is motion, not divergence.
TEST(Simulate, DoesNotMistakeFreeFallForDivergence) {
    Rope rope = seed_rope(16);
    rope.stiffness = 0.0;
    EXPECT_FALSE(simulate(rope, find_method("symplectic_euler"), stepping(1.0, 16), 2000).diverged);
}

}  // namespace
}  // namespace ropesim
