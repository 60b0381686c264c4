// The places where methods fail: what theory says of each. Most have a golden case of the same name.

#include "simulation/diagnostics.h"
#include "study/method_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace ropesim {
namespace {

Scene golden(std::string_view name) {
    for (const BuiltinScene& each : builtin_scenes())
        if (each.name == name) return parse_scene(each.toml, name);
    throw std::runtime_error("no scene " + std::string(name));
}

// A rope of a scene as the scene moves it.
struct Moving {
    Moving(const Scene& scene, std::size_t index)
        : problem(ropesim::problem(scene, scene.ropes[index])),
          method(find_method(scene.ropes[index].method)),
          stepping(ropesim::stepping(problem, problem.steps_per_frame)) {}

    Problem problem;
    const Method& method;
    Stepping stepping;
};

State state_at(const Moving& rope, long frame) {
    MovingRope moving(rope.problem.rope, rope.method, rope.stepping);
    while (frame-- > 0) moving.advance();
    return moving.state();
}

double largest_stretch(const Scene& scene, std::size_t index, long frames) {
    const Moving rope(scene, index);
    return simulate(rope.problem.rope, rope.method, rope.stepping, frames).summary.largest_stretch;
}

// One mass that bounces on a spring of angular frequency 10 below its pin.
Scene bouncing(const char* method, int steps) {
    Scene scene = golden("runge-kutta-energy");
    scene.ropes.resize(1);
    scene.ropes[0].method = method;
    scene.ropes[0].end = scene.ropes[0].start - Eigen::Array2d(0.0, 126.0);
    scene.steps_per_frame = steps;
    return scene;
}

// Its distance from equilibrium and its velocity / 10, together: constant in time.
double amplitude(const Moving& rope, long frame) {
    const State state = state_at(rope, frame);
    const double equilibrium = rope.problem.rope.rest_length + 1.0 / rope.problem.rope.stiffness;
    return std::hypot(-state.position(1, 1) - equilibrium, state.velocity(1, 1) / 10.0);
}

// What is left of an amplitude after a step is |1 + iz| = sqrt(1 + z²), z = h omega, for explicit Euler: it
// grows at every step size.
TEST(ExplicitEuler, GrowsAtEveryStep) {
    for (const int steps : {64, 256, 2048}) {
        const Moving rope(bouncing("explicit_euler", steps), 0);
        const double z = 10.0 / steps;
        const double growth = std::pow(1.0 + z * z, 0.5 * steps * 3);
        EXPECT_NEAR(amplitude(rope, 3) / amplitude(rope, 0), growth, 1e-9 * growth) << steps;
        EXPECT_GT(growth, 1.0);
    }
}

// |1 + iz - z²/2 - iz³/6 + z⁴/24|² = 1 - z⁶/72 + z⁸/576, below the stability limit less than 1.
TEST(RungeKutta4, LosesEnergyBelowItsLimit) {
    const Moving rope(golden("runge-kutta-energy"), 1);
    const double z = 10.0 / 16.0;
    const double left = std::pow(1.0 - std::pow(z, 6) / 72.0 + std::pow(z, 8) / 576.0, 0.5 * 16 * 119);
    EXPECT_NEAR(amplitude(rope, 119) / amplitude(rope, 0), left, 1e-9);
    EXPECT_LT(left * left, 0.25);  // of the energy
    const Moving splitting(golden("runge-kutta-energy"), 0);
    EXPECT_NEAR(amplitude(splitting, 119) / amplitude(splitting, 0), 1.0, 0.01);
}

// 1 / |1 - iz|: of the energy a step leaves 1 / (1 + z²).
TEST(BackwardEuler, DampsWhatIsNotDamped) {
    const Moving rope(bouncing("backward_euler", 64), 0);
    const double z = 10.0 / 64.0;
    EXPECT_NEAR(amplitude(rope, 5) / amplitude(rope, 0), std::pow(1.0 + z * z, -0.5 * 64 * 5), 1e-9);
    const Scene scene = golden("implicit-damping");
    const auto energy_left = [&](std::size_t index) {
        const Moving both(scene, index);
        const auto energy_at = [&](long frame) {
            const Energy now = energy(both.problem.rope, both.problem.model, state_at(both, frame));
            return now.kinetic + now.spring;
        };
        return energy_at(119);
    };
    EXPECT_LT(energy_left(1), 0.7 * energy_left(0));
}

TEST(SymplecticEuler, FailsAtEightStepsAndHoldsAtTen) {
    const Scene scene = golden("unstable-steps");
    for (std::size_t index = 0; index < 3; ++index) {
        const Moving rope(scene, index);
        const bool holds = index == 2;
        EXPECT_EQ(fewest_stable_steps(rope.problem.rope, rope.method, 1.0, 0.0), 10);
        EXPECT_EQ(stable(rope.problem.rope, rope.method, rope.stepping), holds);
        EXPECT_EQ(simulate(rope.problem.rope, rope.method, rope.stepping, 60).diverged.has_value(), !holds);
    }
}

// Hanging at rest, link i of n carries n - i masses: together they are m g n (n + 1) / 2k longer than at rest
// length. A sweep leaves many times that; ten sweeps, or as many steps, leave less.
TEST(Xpbd, IsTooSoftAtFewSweeps) {
    const Scene scene = golden("xpbd-soft");
    const double sag = 63.0 * 64.0 / 2.0 / 10000.0;
    const auto found = [&](std::size_t index) {
        return rope_length(state_at(Moving(scene, index), 59).position) - 300.0;
    };
    EXPECT_NEAR(found(3), sag, 0.01 * sag);
    EXPECT_GT(found(0), 50.0 * sag);
    EXPECT_LT(found(1), 0.3 * found(0));
    EXPECT_LT(found(2), 0.3 * found(0));
}

TEST(ConstraintProjection, StretchesTheMoreTheLongerTheRope) {
    const Scene scene = golden("sweeps-stretch");
    const double of_64 = largest_stretch(scene, 1, 40);
    const double of_512 = largest_stretch(scene, 2, 40);
    EXPECT_LT(largest_stretch(scene, 0, 40), 1e-12);
    EXPECT_GT(of_64, 0.1);
    EXPECT_GT(of_512, 4.0 * of_64);
}

TEST(ConstraintProjection, LetsAHeavyEndFall) {
    const Scene scene = golden("thousandfold-end");
    EXPECT_LT(largest_stretch(scene, 0, 60), 1e-12);
    EXPECT_GT(largest_stretch(scene, 1, 60), 0.2);
}

// Links that nearly lie on one line pull many times as hard as what hangs on them.
TEST(DirectProjection, HoldsWhereConstraintsAreNearlyDependent) {
    const Scene scene = golden("nearly-dependent");
    const Moving rope(scene, 0);
    const Trajectory motion = simulate(rope.problem.rope, rope.method, rope.stepping, 60);
    ASSERT_FALSE(motion.diverged);
    EXPECT_LT(motion.summary.largest_stretch, 1e-11);
    EXPECT_GT(motion.summary.largest_tension, 10.0 * 33.0);
    EXPECT_GT(largest_stretch(scene, 1, 60), 0.002);
}

// Height over its pin of a mass that falls from x0 > 0 at rest and passes the pin: on either side of it
// x'' = -g - k (x -+ l), a cosine about ±l - g / k.
double bounce(double x0, double time) {
    const double k = 0.5, l = 60.0, omega = std::sqrt(k);
    const double above = l - 1.0 / k;
    const double below = -l - 1.0 / k;
    const double crossing = std::acos(-above / (x0 - above)) / omega;
    if (time < crossing) return above + (x0 - above) * std::cos(omega * time);
    const double speed = -(x0 - above) * omega * std::sin(omega * crossing);
    const double after = omega * (time - crossing);
    return below - below * std::cos(after) + speed / omega * std::sin(after);
}

// The greatest error over starts that put the passage anywhere in a step.
double passing_error(const char* method, int steps, long frame) {
    double worst = 0.0;
    for (int i = 0; i < 32; ++i) {
        Scene scene = golden("zero-length");
        scene.steps_per_frame = steps;
        scene.ropes[0].method = method;
        scene.ropes[0].start = {0.0, 0.0};
        scene.ropes[0].end = {0.0, 150.0 + 0.5 * i};
        const Points end = state_at(Moving(scene, 0), frame).position;
        worst = std::max(worst, std::abs(end(1, 1) - bounce(150.0 + 0.5 * i, static_cast<double>(frame))));
    }
    return worst;
}

// The force turns round within a step: any method makes an error of the velocity of order h there.
TEST(EveryMethod, IsOfOrderOneWhereALinkPassesThroughZeroLength) {
    for (const char* method : {"stormer_verlet", "blanes_moan_4", "blanes_moan_6"}) {
        const double order = std::log2(passing_error(method, 64, 5) / passing_error(method, 256, 5)) / 2.0;
        EXPECT_NEAR(order, 1.0, 0.3) << method;
    }
    EXPECT_GT(std::log2(passing_error("stormer_verlet", 64, 2) / passing_error("stormer_verlet", 128, 2)),
              1.9);
}

double distance_of_disturbed(const Moving& rope, long frame) {
    Moving disturbed = rope;
    disturbed.problem.rope.start(8, 0) += 1e-9;
    return greatest_distance(state_at(rope, frame).position, state_at(disturbed, frame).position);
}

// While a rope falls freely a disturbance stays as it is; the snap magnifies it.
TEST(Snap, MagnifiesWhatWasSmall) {
    const Moving rope(golden("snap"), 0);
    EXPECT_LT(distance_of_disturbed(rope, 5), 3e-9);
    EXPECT_GT(distance_of_disturbed(rope, 59), 1e-6);
}

}  // namespace
}  // namespace ropesim
