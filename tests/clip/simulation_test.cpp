#include "clip/simulation.h"

#include <gmock/gmock.h>

#include <cstdio>

namespace ropesim {
namespace {

using testing::StartsWith;

Scene seed_with(int steps_per_frame, const std::string& method) {
    Scene scene = parse_scene(builtin_scenes().front().toml, "seed");
    scene.steps_per_frame = steps_per_frame;
    scene.frames = 60;
    scene.ropes.resize(1);
    scene.ropes[0].method = method;
    return scene;
}

void advance_to(long frame, Simulation& simulation) {
    while (simulation.frame() < frame) simulation.advance();
}

// Frame by frame, what the simulation library gives as a whole.
TEST(Simulation, GoesTheWayOfTheTrajectories) {
    for (const BuiltinScene& each : builtin_scenes()) {
        const Scene scene = parse_scene(each.toml, each.name);
        const std::vector<Trajectory> trajectories = simulate(scene, runs(scene));
        const Positions expected = positions(trajectories, parse_frames("", scene.frames));
        Simulation simulation(scene, Simulation::Errors::estimated);
        for (long frame = 0; frame < scene.frames; ++frame) {
            advance_to(frame, simulation);
            for (std::size_t i = 0; i < trajectories.size(); ++i) {
                const Points& points = expected.at(frame)[i];
                ASSERT_EQ(simulation.positions()[i].rows(), points.rows()) << each.name << ", " << frame;
                ASSERT_TRUE((simulation.positions()[i] == points).all()) << each.name << ", " << frame;
            }
        }
        for (std::size_t i = 0; i < trajectories.size(); ++i) {
            EXPECT_EQ(simulation.diverged(i), trajectories[i].diverged) << each.name;
            EXPECT_EQ(simulation.summaries()[i].largest_stretch, trajectories[i].summary.largest_stretch);
            EXPECT_EQ(simulation.summaries()[i].largest_tension, trajectories[i].summary.largest_tension);
            EXPECT_EQ(simulation.summaries()[i].energy_drift(), trajectories[i].summary.energy_drift());
        }
    }
}

TEST(Simulation, EndsOneRopeWhileTheOthersGoOn) {
    Scene scene = seed_with(8, "symplectic_euler");
    SceneRope other = scene.ropes[0];
    other.name = "projected";
    other.method = "constraint_projection";
    scene.ropes.push_back(other);
    Simulation simulation(scene, Simulation::Errors::estimated);
    advance_to(scene.frames - 1, simulation);
    EXPECT_TRUE(simulation.diverged(0));
    EXPECT_EQ(simulation.positions()[0].rows(), 0);
    EXPECT_FALSE(simulation.diverged(1));
    EXPECT_EQ(simulation.positions()[1].rows(), 16);
    EXPECT_TRUE(simulation.positions()[1].isFinite().all());
    EXPECT_THAT(diagnostics_csv_lines(simulation), StartsWith("59,projected,"));
}

// A mass that hangs at rest from a pin, 10 below it: its spring carries its weight of 1.
TEST(DiagnosticsCsv, TellsOfARopeThatHangsAtRest) {
    Scene scene = seed_with(64, "stormer_verlet");
    SceneRope& rope = scene.ropes[0];
    rope.nodes = 2;
    rope.start = {0.0, 10.0};
    rope.end = {0.0, 0.0};
    rope.rest_length = 9.99;  // 1 / 100 shorter: in equilibrium
    Simulation simulation(scene, Simulation::Errors::estimated);
    EXPECT_THAT(diagnostics_csv_lines(simulation), StartsWith("0,Euler,0,"));
    advance_to(59, simulation);
    double kinetic = 1.0, spring = 0.0, gravity = 0.0, stretch = 0.0, tension = 0.0, length = 0.0;
    ASSERT_EQ(std::sscanf(diagnostics_csv_lines(simulation).c_str(), "59,Euler,%lf,%lf,%lf,%lf,%lf,%lf",
                          &kinetic, &spring, &gravity, &stretch, &tension, &length),
              6);
    EXPECT_NEAR(kinetic, 0.0, 1e-20);
    EXPECT_NEAR(spring, 0.5 * 100.0 * 0.01 * 0.01, 1e-12);
    EXPECT_NEAR(gravity, 10.0, 1e-12);
    EXPECT_NEAR(stretch, 0.01 / 9.99, 1e-12);
    EXPECT_NEAR(tension, 1.0, 1e-10);
    EXPECT_NEAR(length, 10.0, 1e-12);
}

}  // namespace
}  // namespace ropesim
