#include "scene/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <random>

namespace ropesim {
namespace {

using testing::HasSubstr;
using testing::Not;

Scene a_scene() {
    Scene scene;
    scene.ropes.resize(1);
    scene.ropes[0].name = "rope 1";
    scene.ropes[0].end = {-400.0, 200.0};
    return scene;
}

Scene read_back(const Scene& scene) {
    return parse_scene(to_toml(scene), "written.toml");
}

// Numbers of all magnitudes and all bits of the mantissa.
class Dice {
  public:
    explicit Dice(unsigned seed) : engine_(seed) {}

    int integer(int least, int greatest) { return std::uniform_int_distribution(least, greatest)(engine_); }
    bool coin() { return integer(0, 1) == 1; }
    double number(double least_exponent, double greatest_exponent) {
        return std::pow(10.0, std::uniform_real_distribution(least_exponent, greatest_exponent)(engine_));
    }
    Eigen::Array2d point() {
        return {(coin() ? 1.0 : -1.0) * number(-4, 4), (coin() ? 1.0 : -1.0) * number(-4, 4)};
    }
    std::array<std::uint8_t, 3> color() {
        const auto channel = [&] { return static_cast<std::uint8_t>(integer(0, 255)); };
        return {channel(), channel(), channel()};
    }

  private:
    std::mt19937 engine_;
};

SceneRope random_rope(Dice& dice, int number) {
    SceneRope rope;
    rope.name = "\"\\'# \u00e4\u20ac\U0001f409";
    rope.name += std::to_string(number);
    rope.method = dice.coin() ? "stormer_verlet" : "constraint_projection";
    rope.start = dice.point();
    if (dice.coin()) rope.via = {dice.point(), dice.point()};
    rope.end = dice.point();
    rope.nodes = dice.integer(2, 8);
    if (dice.coin())
        for (int i = 0; i < rope.nodes; ++i) rope.masses.push_back(dice.number(-6, 6));
    else
        rope.mass = dice.number(-6, 6);
    rope.stiffness = dice.number(-3, 6);
    if (dice.coin()) rope.rest_length = dice.number(-6, 6);
    rope.pinned.clear();
    if (dice.coin()) rope.pinned = {-1, 0};
    (dice.coin() ? rope.damping : rope.damping_factor) = dice.number(-6, -1);
    if (dice.coin()) rope.steps_per_frame = dice.integer(1, 1'000'000);
    rope.sweeps = dice.integer(1, 1000);
    rope.color = dice.color();
    rope.line_width = dice.number(-2, 2);
    rope.point_size = dice.number(-2, 2);
    return rope;
}

Scene random_scene(unsigned seed) {
    Dice dice(seed);
    Scene scene;
    if (dice.coin()) scene.title = "a = \"b\" # \\n";
    scene.gravity = dice.point();
    scene.frames = dice.integer(1, 10'000'000);
    scene.steps_per_frame = dice.integer(1, 1'000'000);
    scene.frame_time = dice.number(-5, 5);
    scene.size = {dice.integer(1, 16384), dice.integer(1, 16384)};
    scene.view = {dice.point(), dice.number(-3, 6)};
    scene.background = dice.color();
    if (dice.coin()) scene.tolerance = dice.number(-8, 5);
    scene.words = dice.coin();
    for (int i = dice.integer(1, 4); i > 0; --i) scene.ropes.push_back(random_rope(dice, i));
    return scene;
}

TEST(ToToml, ReadsBackAsTheSameScene) {
    for (unsigned seed = 0; seed < 500; ++seed) {
        const Scene scene = random_scene(seed);
        const Scene again = read_back(scene);
        EXPECT_EQ(again, scene) << to_toml(scene);
        EXPECT_EQ(to_toml(again), to_toml(scene));
    }
}

TEST(ToToml, WritesNumbersShortAndWithAPoint) {
    Scene scene = a_scene();
    scene.frame_time = 0.1;
    scene.view.height = 1e9;
    const std::string text = to_toml(scene);
    EXPECT_THAT(text, HasSubstr("frame_time = 0.1\n"));
    EXPECT_THAT(text, HasSubstr("height = 1e+09 "));
    EXPECT_THAT(text, HasSubstr("end = [-400.0, 200.0]\n"));
    EXPECT_THAT(text, HasSubstr("frames = 120\n"));
    EXPECT_THAT(text, HasSubstr("color = \"#ffffff\"\n"));
}

TEST(ToToml, WritesOnlyKeysThatHaveASay) {
    Scene scene = a_scene();
    EXPECT_THAT(to_toml(scene), Not(HasSubstr("masses")));
    EXPECT_THAT(to_toml(scene), Not(HasSubstr("rest_length")));
    scene.ropes[0].masses.assign(16, 2.0);
    EXPECT_THAT(to_toml(scene), Not(HasSubstr("mass =")));
}

// 0 == -0: were both written as they are, equal scenes would have two texts and two digests.
TEST(ToToml, WritesEqualScenesEqually) {
    Scene plus = a_scene();
    Scene minus = a_scene();
    minus.gravity.x() = -0.0;
    minus.ropes[0].start.y() = -0.0;
    ASSERT_EQ(plus, minus);
    EXPECT_EQ(to_toml(plus), to_toml(minus));
    const Scene read = parse_scene("gravity = [-0.0, -1.0]\n[[rope]]\nstart = [0, 0]\nend = [1, 0]\n", "a");
    EXPECT_FALSE(std::signbit(read.gravity.x()));
}

TEST(ToToml, DoesNotMindTheLocale) {
    const std::string before = to_toml(random_scene(7));
    const std::string old = std::setlocale(LC_ALL, nullptr);
    for (const char* locale : {"de_DE.UTF-8", "fr_FR.UTF-8"}) std::setlocale(LC_ALL, locale);
    EXPECT_EQ(to_toml(random_scene(7)), before);
    EXPECT_EQ(parse_scene(before, "a"), random_scene(7));
    std::setlocale(LC_ALL, old.c_str());
}

// Each member that is changed alone must change both the text and the comparison.
TEST(ToToml, MissesNoMember) {
    const auto tells_apart = [](auto change) {
        const Scene before = a_scene();
        Scene after = a_scene();
        change(after, after.ropes[0]);
        EXPECT_FALSE(before == after);
        EXPECT_NE(to_toml(before), to_toml(after));
        EXPECT_EQ(read_back(after), after) << to_toml(after);
    };
    tells_apart([](Scene& scene, SceneRope&) { scene.title = std::string("t"); });
    tells_apart([](Scene& scene, SceneRope&) { scene.gravity.y() = 1.0; });
    tells_apart([](Scene& scene, SceneRope&) { scene.frames = 7; });
    tells_apart([](Scene& scene, SceneRope&) { scene.steps_per_frame = 7; });
    tells_apart([](Scene& scene, SceneRope&) { scene.frame_time = 7.0; });
    tells_apart([](Scene& scene, SceneRope&) { scene.size[1] = 7; });
    tells_apart([](Scene& scene, SceneRope&) { scene.view.center.x() = 7.0; });
    tells_apart([](Scene& scene, SceneRope&) { scene.view.height = 7.0; });
    tells_apart([](Scene& scene, SceneRope&) { scene.background[2] = 7; });
    tells_apart([](Scene& scene, SceneRope&) { scene.words = false; });
    tells_apart([](Scene& scene, SceneRope& rope) {
        const SceneRope copy = rope;
        scene.ropes.push_back(copy);
        scene.ropes[1].name = "another";
    });
    tells_apart([](Scene&, SceneRope& rope) { rope.name = std::string("n"); });
    tells_apart([](Scene&, SceneRope& rope) { rope.method = "stormer_verlet"; });
    tells_apart([](Scene&, SceneRope& rope) { rope.start.x() = 7.0; });
    tells_apart([](Scene&, SceneRope& rope) { rope.via = {{7.0, 7.0}}; });
    tells_apart([](Scene&, SceneRope& rope) { rope.end.y() = 7.0; });
    tells_apart([](Scene&, SceneRope& rope) { rope.nodes = 7; });
    tells_apart([](Scene&, SceneRope& rope) { rope.mass = 7.0; });
    tells_apart([](Scene&, SceneRope& rope) { rope.masses.assign(16, 7.0); });
    tells_apart([](Scene&, SceneRope& rope) { rope.stiffness = 7.0; });
    tells_apart([](Scene&, SceneRope& rope) { rope.rest_length = 7.0; });
    tells_apart([](Scene&, SceneRope& rope) { rope.pinned = {}; });
    tells_apart([](Scene&, SceneRope& rope) { rope.damping = 0.5; });
    tells_apart([](Scene&, SceneRope& rope) { rope.damping_factor = 0.5; });
    tells_apart([](Scene&, SceneRope& rope) { rope.sweeps = 7; });
    tells_apart([](Scene&, SceneRope& rope) { rope.color[0] = 7; });
    tells_apart([](Scene&, SceneRope& rope) { rope.line_width = 7.0; });
    tells_apart([](Scene&, SceneRope& rope) { rope.point_size = 7.0; });
}

}  // namespace
}  // namespace ropesim
