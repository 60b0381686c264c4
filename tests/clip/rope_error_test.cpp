#include "clip/rope_error.h"

#include "clip/manifest.h"
#include "clip/render_clip.h"
#include "clip/simulation.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <cmath>

namespace ropesim {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

Scene seed_of(int frames) {
    Scene scene = parse_scene(builtin_scenes().front().toml, "seed");
    scene.frames = frames;
    return scene;
}

void finish(const Scene& scene, Simulation& simulation) {
    while (simulation.frame() < scene.frames - 1) simulation.advance();
}

// The assignment's figures at t = 20: symplectic Euler is 0.195 off, of which estimates know two digits.
TEST(RopeError, KnowsTheErrorOfTheSeedsEuler) {
    const Scene scene = seed_of(21);
    Simulation simulation(scene, Simulation::Errors::estimated);
    finish(scene, simulation);
    const RopeError::Worst worst = simulation.error(0)->worst();
    EXPECT_EQ(worst.bound, RopeError::Bound::about);
    EXPECT_NEAR(worst.pixels, 0.195, 0.0005);
    EXPECT_EQ(worst.frame, 20);
    EXPECT_EQ(simulation.error(0)->last(), worst.pixels);
    EXPECT_EQ(simulation.error(0)->frames().size(), 21u);
    EXPECT_EQ(simulation.error(0)->frames()[0], 0.0F);
}

// The same rope on a picture of half the pixels is half as wrong.
TEST(RopeError, IsInPixelsOfThePicture) {
    Scene scene = seed_of(21);
    scene.view.height = 2.0 * scene.size[1];
    Simulation simulation(scene, Simulation::Errors::estimated);
    finish(scene, simulation);
    EXPECT_NEAR(simulation.error(0)->worst().pixels, 0.195 / 2.0, 0.0005);
}

// A chaotic rope: beyond some frame no run tells where it is, and a method as good as those that tell has not
// lost it long before.
TEST(RopeError, SaysMoreThanBeyondWhatItCanTell) {
    Scene scene = seed_of(600);
    scene.steps_per_frame = 8;
    scene.ropes[0].method = "blanes_moan_6";
    Simulation simulation(scene, Simulation::Errors::estimated);
    finish(scene, simulation);
    const RopeError& error = *simulation.error(0);
    EXPECT_EQ(error.worst().bound, RopeError::Bound::more_than);
    EXPECT_FALSE(error.last());
    EXPECT_FALSE(error.frames().back());
    EXPECT_THAT(error_line(simulation), HasSubstr("Euler more than "));
}

// A rope that falls freely is exact but for rounding.
TEST(RopeError, SaysLessThanWhereThereIsOnlyRounding) {
    Scene scene = seed_of(21);
    scene.ropes.resize(1);
    scene.ropes[0].method = "stormer_verlet";
    scene.ropes[0].pinned.clear();
    Simulation simulation(scene, Simulation::Errors::estimated);
    finish(scene, simulation);
    EXPECT_EQ(simulation.error(0)->worst().bound, RopeError::Bound::less_than);
    EXPECT_LT(simulation.error(0)->worst().pixels, 1e-8);
}

TEST(RopeError, IsLeftOutWhereItWouldCostTooMuchAndWhereLinksDoNotFit) {
    Scene scene = seed_of(2);
    scene.ropes[0].nodes = 2000;
    const Simulation too_much(scene, Simulation::Errors::estimated);
    EXPECT_EQ(too_much.error(1), nullptr);
    EXPECT_THAT(error_line(too_much), HasSubstr("more than a tenth"));
    const auto json = nlohmann::json::parse(clip_json(scene, too_much, {}, {0}, "a renderer"));
    EXPECT_THAT(json["ropes"][0]["error"]["left_out"].get<std::string>(), HasSubstr("more than a tenth"));
    scene = seed_of(2);
    scene.ropes[0].method = "constraint_projection";
    scene.ropes[0].rest_length = 20.0;
    const Simulation stretched(scene, Simulation::Errors::estimated);
    EXPECT_EQ(stretched.error(0), nullptr);
    EXPECT_NE(stretched.error(1), nullptr);
    const Simulation unwanted(scene, Simulation::Errors::left_out);
    EXPECT_EQ(unwanted.error(1), nullptr);
    EXPECT_EQ(error_line(unwanted), "");
}

// In the first frame all masses but the first fall freely, which Euler gets wrong by g h t / 2, 1/128;
// lighter masses feel their springs more.
TEST(ErrorLine, NamesAllOfAFewRopesAndTheWorstOfMany) {
    Scene scene = seed_of(2);
    Simulation two(scene, Simulation::Errors::estimated);
    finish(scene, two);
    EXPECT_EQ(error_line(two),
              "error, worst frame: Euler 0.0078 px (last 0.0078 px), Verlet 0.0078 px (last 0.0078 px)");
    for (int i = 0; i < 6; ++i) {
        scene.ropes.push_back(scene.ropes[0]);
        scene.ropes.back().name = "copy " + std::to_string(i);
    }
    scene.ropes[4].mass = 0.1;
    Simulation eight(scene, Simulation::Errors::estimated);
    finish(scene, eight);
    EXPECT_THAT(error_line(eight),
                AllOf(StartsWith("error, worst frame: copy 2 "), HasSubstr("worst of 8 ropes")));
}

TEST(ClipJson, HasTheErrorOfEveryFrame) {
    const Scene scene = seed_of(21);
    Simulation simulation(scene, Simulation::Errors::estimated);
    finish(scene, simulation);
    const auto json =
        nlohmann::json::parse(clip_json(scene, simulation, {}, parse_frames("", 21), "a renderer"));
    const auto& error = json["ropes"][0]["error"];
    EXPECT_EQ(error["px"].size(), 21u);
    EXPECT_NEAR(error["px"][20].get<double>(), 0.195, 0.0005);
    EXPECT_EQ(error["worst_px"], error["px"][20]);
    EXPECT_EQ(error["worst"], "about");
    EXPECT_THAT(error["estimated_by"].get<std::string>(), StartsWith("blanes_moan_6 at "));
}

}  // namespace
}  // namespace ropesim
