// What the assignment says, and what is so.
#include "simulation/chains.h"
#include "simulation/diagnostics.h"
#include "simulation/simulate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace ropesim {
namespace {

struct Vec {
    double x = 0.0;
    double y = 0.0;
};

// The assignment's rules, mass by mass and spring by spring, in its own words.
struct SeedProgram {
    std::vector<Vec> position;
    std::vector<Vec> last_position;
    double rest_length;
    double dt;
    double damping;

    SeedProgram(int masses, double steps_per_frame, double c)
        : rest_length(400.0 / (masses - 1)), dt(1.0 / steps_per_frame), damping(c) {
        for (int i = 0; i < masses; ++i) position.push_back({0.0 - i * rest_length, 200.0});
        last_position = position;
    }

    void move(std::size_t i, Vec acceleration) {
        const Vec now = position[i];
        position[i].x += (1.0 - damping) * (now.x - last_position[i].x) + acceleration.x * dt * dt;
        position[i].y += (1.0 - damping) * (now.y - last_position[i].y) + acceleration.y * dt * dt;
        last_position[i] = now;
    }

    void step_springs() {
        std::vector<Vec> force(position.size(), Vec{0.0, -1.0});
        for (std::size_t i = 0; i + 1 < position.size(); ++i) {
            const Vec d{position[i + 1].x - position[i].x, position[i + 1].y - position[i].y};
            const double length = std::hypot(d.x, d.y);
            const double pull = 100.0 * (length - rest_length) / length;
            force[i].x += pull * d.x;
            force[i].y += pull * d.y;
            force[i + 1].x -= pull * d.x;
            force[i + 1].y -= pull * d.y;
        }
        for (std::size_t i = 1; i < position.size(); ++i) move(i, force[i]);
    }

    void step_constraints() {
        for (std::size_t i = 1; i < position.size(); ++i) move(i, {0.0, -1.0});
        for (std::size_t i = 0; i + 1 < position.size(); ++i) {
            const Vec d{position[i + 1].x - position[i].x, position[i + 1].y - position[i].y};
            const double length = std::hypot(d.x, d.y);
            const double half = (length - rest_length) / length / 2.0;
            if (i > 0) position[i] = {position[i].x + half * d.x, position[i].y + half * d.y};
            position[i + 1] = {position[i + 1].x - half * d.x, position[i + 1].y - half * d.y};
        }
    }

    double distance_to(const Points& points) const {
        double greatest = 0.0;
        for (std::size_t i = 0; i < position.size(); ++i) {
            const auto row = static_cast<Eigen::Index>(i);
            greatest = std::max(greatest,
                                std::hypot(points(row, 0) - position[i].x, points(row, 1) - position[i].y));
        }
        return greatest;
    }
};

Points run(const char* method, int masses, long steps, double damping_factor, long frames) {
    Stepping each = stepping(1.0, steps);
    each.damping_factor = damping_factor;
    return positions_at(seed_rope(masses), find_method(method), each, frames);
}

TEST(SeedVerlet, IsTheAssignmentsToTheLetter) {
    for (const double damping : {0.0, 0.00005}) {
        SeedProgram program(16, 64, damping);
        for (int step = 0; step < 20 * 64; ++step) program.step_springs();
        EXPECT_LT(program.distance_to(run("seed_verlet", 16, 64, damping, 20)), 1e-8) << damping;
    }
}

TEST(SeedConstraints, IsTheAssignmentsToTheLetter) {
    for (const double damping : {0.0, 0.00005}) {
        SeedProgram program(16, 64, damping);
        for (int step = 0; step < 20 * 64; ++step) program.step_constraints();
        EXPECT_LT(program.distance_to(run("seed_constraints", 16, 64, damping, 20)), 1e-8) << damping;
    }
}

// Its start costs Verlet an order: what is left is symplectic Euler.
TEST(SeedVerlet, UndampedIsSymplecticEulerToRounding) {
    const Points euler = run("symplectic_euler", 16, 64, 0.0, 60);
    const Points verlet = run("seed_verlet", 16, 64, 0.0, 60);
    EXPECT_LT(greatest_distance(euler, verlet), 1e-8);
    EXPECT_GT(greatest_distance(euler, run("stormer_verlet", 16, 64, 0.0, 60)), 0.01);
}

// The same factor per step damps sixteen times as much at sixteen times the steps; as a rate it does not.
TEST(Damping, AsARateIsTheSamePhysicsAtEveryStep) {
    const auto by_rate = [](long steps) {
        Rope rope = seed_rope(16);
        rope.damping = 0.1;
        return positions_at(rope, find_method("stormer_verlet"), stepping(1.0, steps), 20);
    };
    EXPECT_LT(greatest_distance(by_rate(64), by_rate(1024)), 0.001);
    EXPECT_GT(
        greatest_distance(run("seed_verlet", 16, 64, 0.002, 20), run("seed_verlet", 16, 1024, 0.002, 20)),
        10.0);
}

TEST(ExplicitEuler, HasBlownUpByFrame20At64Steps) {
    const Trajectory trajectory =
        simulate(seed_rope(16), find_method("explicit_euler"), stepping(1.0, 64), 120);
    ASSERT_TRUE(trajectory.diverged);
    EXPECT_LE(*trajectory.diverged, 20);
}

TEST(StabilityLimit, OfTheSeedsRopeIsTenStepsPerFrame) {
    for (const char* name : {"symplectic_euler", "stormer_verlet", "seed_verlet"}) {
        const Method& method = find_method(name);
        EXPECT_EQ(fewest_stable_steps(seed_rope(16), method, 1.0, 0.00005), 10) << name;
        EXPECT_TRUE(simulate(seed_rope(16), method, stepping(1.0, 8), 120).diverged) << name;
        EXPECT_FALSE(simulate(seed_rope(16), method, stepping(1.0, 16), 120).diverged) << name;
    }
}

}  // namespace
}  // namespace ropesim
