#include "study/failures.h"

#include "simulation/diagnostics.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ropesim {
namespace {

Problem three_masses(int frames) {
    Scene scene;
    scene.frames = frames;
    SceneRope rope;
    rope.nodes = 3;
    rope.end = {-200.0, 0.0};
    scene.ropes.push_back(rope);
    return problem(scene, scene.ropes[0]);
}

TEST(Quality, IsByPixels) {
    EXPECT_EQ(quality(0.0), Quality::exact);
    EXPECT_EQ(quality(0.5), Quality::exact);
    EXPECT_EQ(quality(0.6), Quality::usable);
    EXPECT_EQ(quality(8.1), Quality::wrong);
    EXPECT_EQ(quality(std::numeric_limits<double>::infinity()), Quality::diverged);
}

// Coarser than the limit by a third a method ends diverged, finer it does not, whatever the stiffness.
TEST(StabilityMap, TurnsWhereLinearTheorySaysSo) {
    const std::vector<const Method*> methods{&find_method("symplectic_euler"), &find_method("runge_kutta_4")};
    long reported = 0;
    const StabilityMap map = stability_map(three_masses(21), Against::stiffness, methods,
                                           [&](long done, long) { reported = done; });
    ASSERT_EQ(map.cells.size(), methods.size() * map.values.size() * map.steps.size());
    EXPECT_EQ(reported, static_cast<long>(map.cells.size()));
    for (std::size_t m = 0; m < methods.size(); ++m) {
        const std::vector<double> limit = map.limit(*methods[m]);
        for (std::size_t v = 0; v < map.values.size(); ++v) {
            // h omega is proportional to the square root of the stiffness.
            EXPECT_NEAR(limit[v], limit.back() * std::sqrt(map.values[v] / map.values.back()), 1.0);
            for (std::size_t s = 0; s < map.steps.size(); ++s) {
                const Cell& cell = map.cells[(m * map.values.size() + v) * map.steps.size() + s];
                ASSERT_EQ(cell.method, methods[m]);
                ASSERT_EQ(cell.steps, map.steps[s]);
                const auto steps = static_cast<double>(cell.steps);
                const bool finer = steps > 1.1 * limit[v];
                const bool coarser = steps < 0.7 * (limit[v] - 1.0);
                if (!finer && !coarser) continue;
                EXPECT_EQ(quality(cell.worst) == Quality::diverged, coarser)
                    << cell.method->name << ' ' << cell.steps << ' ' << cell.value;
            }
        }
    }
}

// On a stiff rope a method holds until it is unstable: linear theory names the very steps.
TEST(Failures, StandWhereLinearTheorySaysSo) {
    Problem problem = three_masses(41);
    problem.rope.stiffness = 1e5;
    const std::vector<const Method*> methods{&find_method("stormer_verlet"), &find_method("blanes_moan_4")};
    const std::vector<Failure> all = failures(problem, truth(problem), methods, [](long, long) {});
    ASSERT_EQ(all.size(), methods.size());
    for (const Failure& failure : all) {
        ASSERT_TRUE(failure.holds && failure.fails);
        const auto theory = fewest_stable_steps(problem.rope, *failure.method, problem.frame_time, 0.0);
        EXPECT_EQ(failure.fails->steps + 1, failure.holds->steps);
        EXPECT_NEAR(static_cast<double>(failure.holds->steps), static_cast<double>(*theory),
                    0.02 * static_cast<double>(*theory));
        EXPECT_LE(failure.holds->worst, 8.0);
        EXPECT_GT(failure.fails->worst, 8.0);
        ASSERT_EQ(failure.holds->moments.size(), 3u);
        EXPECT_EQ(failure.holds->moments.back().frame, 40);
        ASSERT_EQ(failure.fails->moments.size(), 3u);
        EXPECT_LE(failure.fails->moments[0].error, 8.0);
    }
}

TEST(Failures, SayWhereAMethodNeverHoldsOrNeverFails) {
    Problem problem = three_masses(11);
    problem.rope.stiffness = 0.05;  // links that keep their length are far from such springs
    const std::vector<const Method*> methods{&find_method("direct_projection"),
                                             &find_method("blanes_moan_6")};
    const std::vector<Failure> all = failures(problem, truth(problem), methods, [](long, long) {});
    EXPECT_FALSE(all[0].holds);
    EXPECT_EQ(all[0].fails->steps, 4096);
    EXPECT_EQ(all[1].holds->steps, 1);
    EXPECT_FALSE(all[1].fails);
}

// Damping makes explicit Euler stable: at h omega squared below the share of the velocity that is lost.
TEST(StabilityMap, HasALimitOfExplicitEulerOnlyWhereThereIsDamping) {
    const StabilityMap map{three_masses(3), Against::damping, {}, {1}, {0.0, 1.0}, {}};
    const std::vector<double> limit = map.limit(find_method("explicit_euler"));
    EXPECT_EQ(limit[0], 0.0);
    EXPECT_GT(limit[1], 0.0);
}

TEST(StabilityMap, IsALineOfCsvPerCell) {
    StabilityMap map{three_masses(3), Against::damping, {}, {1}, {0.5}, {}};
    map.cells = {{&find_method("xpbd"), 4, 0.5, 3.25}, {&find_method("xpbd"), 8, 0.5, 0.25}};
    EXPECT_EQ(to_csv(map, "somebody"),
              "# somebody\n"
              "method,model,steps_per_frame,damping,worst_px,quality,class\n"
              "xpbd,elastic,4,0.5,3.25,usable,1\n"
              "xpbd,elastic,8,0.5,0.25,exact,0\n");
}

}  // namespace
}  // namespace ropesim
