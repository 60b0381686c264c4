#include "scene/scene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <stdexcept>
#include <string>

namespace ropesim {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

const std::string rope = "[[rope]]\nstart = [0, 200]\nend = [-400, 200]\n";

std::string refusal(const std::string& toml) {
    try {
        parse_scene(toml, "a.toml");
        return "accepted";
    } catch (const std::runtime_error& error) {
        return error.what();
    }
}

// The error's message begins with this place and holds these words.
template <class... Words>
void expect_refusal(const std::string& toml, const std::string& place, const Words&... words) {
    EXPECT_THAT(refusal(toml), AllOf(StartsWith("a.toml:" + place + ": "), HasSubstr(words)...)) << toml;
}

TEST(ParseScene, TakesDefaultsForWhatIsNotSaid) {
    Scene expected;
    expected.ropes.resize(2);
    for (SceneRope& each : expected.ropes) {
        each.start = {0.0, 200.0};
        each.end = {-400.0, 200.0};
    }
    expected.ropes[0].name = "rope 1";
    expected.ropes[1].name = "rope 2";
    EXPECT_EQ(parse_scene(rope + rope, "a.toml"), expected);
}

TEST(ParseScene, ReadsEveryKey) {
    const Scene scene = parse_scene(R"(
title = "T"
gravity = [1, -2.5]
[clip]
frames = 3
steps_per_frame = 4
frame_time = 0.5
size = [7, 8]
view = { center = [9, 10], height = 11 }
background = "#010203"
tolerance = 28
words = false
[[rope]]
name = "N"
method = "seed_constraints"
start = [12, 13]
via = [[14, 15], [16, 17]]
end = [18, 19]
nodes = 20
mass = 21
stiffness = 22
rest_length = 23
pinned = [1, -2]
damping = 24
steps_per_frame = 29
sweeps = 25
color = "#AbCdEf"
line_width = 26
point_size = 27
[[rope]]
start = [0, 0]
end = [1, 0]
nodes = 3
masses = [1, 2.5, 3]
damping_factor = 0.25
)",
                                    "a.toml");
    Scene expected;
    expected.title = "T";
    expected.gravity = {1.0, -2.5};
    expected.frames = 3;
    expected.steps_per_frame = 4;
    expected.frame_time = 0.5;
    expected.size = {7, 8};
    expected.view = {{9.0, 10.0}, 11.0};
    expected.background = {1, 2, 3};
    expected.tolerance = 28.0;
    expected.words = false;
    expected.ropes.resize(2);
    SceneRope& first = expected.ropes[0];
    first.name = "N";
    first.method = "seed_constraints";
    first.start = {12.0, 13.0};
    first.via = {{14.0, 15.0}, {16.0, 17.0}};
    first.end = {18.0, 19.0};
    first.nodes = 20;
    first.mass = 21.0;
    first.stiffness = 22.0;
    first.rest_length = 23.0;
    first.pinned = {1, -2};
    first.damping = 24.0;
    first.steps_per_frame = 29;
    first.sweeps = 25;
    first.color = {0xab, 0xcd, 0xef};
    first.line_width = 26.0;
    first.point_size = 27.0;
    SceneRope& second = expected.ropes[1];
    second.name = "rope 2";
    second.end = {1.0, 0.0};
    second.nodes = 3;
    second.masses = {1.0, 2.5, 3.0};
    second.damping_factor = 0.25;
    EXPECT_EQ(scene, expected);
}

TEST(ParseScene, PointsAtUnknownKeysWithTheNearest) {
    expect_refusal(rope + "stifness = 100\n", "4:1", "unknown key 'stifness'", "[[rope]]", "'stiffness'",
                   "rest_length");
    expect_refusal("[clip]\n  frame = 9\n" + rope, "2:3", "'frame'", "[clip]", "'frames'");
    expect_refusal("[clip]\nview = { centre = [0, 0] }\n" + rope, "2:10", "'centre'", "view", "'center'");
    expect_refusal("titel = \"x\"\n" + rope, "1:1", "'titel'", "'title'");
    expect_refusal("\"a\\nb\" = 1\n" + rope, "1:1", "a\\nb");
}

TEST(ParseScene, PointsAtValuesOfTheWrongType) {
    expect_refusal("[clip]\nframes = \"many\"\n" + rope, "2:10", "frames", "a string", "expected");
    expect_refusal("[clip]\nframes = 64.0\n" + rope, "2:10", "frames", "number", "expected");
    expect_refusal("[clip]\nwords = 1\n" + rope, "2:9", "words", "true or false");
    expect_refusal("[clip]\nview = 640\n" + rope, "2:8", "view", "table");
    expect_refusal("title = 1979-05-27\n" + rope, "1:9", "title", "date", "string");
    expect_refusal("gravity = -1\n" + rope, "1:11", "gravity", "two numbers");
    expect_refusal("gravity = [0, -1, 0]\n" + rope, "1:11", "gravity", "3", "two numbers");
    expect_refusal("gravity = [0, \"down\"]\n" + rope, "1:15", "gravity", "a string");
    expect_refusal(rope + "mass = true\n", "4:8", "mass", "true or false", "expected a number");
    expect_refusal(rope + "pinned = 0\n", "4:10", "pinned", "an array");
    expect_refusal(rope + "pinned = [0, 0.5]\n", "4:14", "pinned", "whole number");
    expect_refusal(rope + "via = [1, 2]\n", "4:8", "via", "two numbers");
    expect_refusal(rope + "name = [\"a\"]\n", "4:8", "name", "a string");
    expect_refusal("clip = 3\n" + rope, "1:8", "clip", "[clip]");
    expect_refusal("rope = 3\n", "1:8", "rope", "[[rope]]");
    expect_refusal("[rope]\nstart = [0, 0]\n", "1:1", "rope", "[[rope]]");
    expect_refusal("rope = [3]\n", "1:9", "rope", "[[rope]]");
    expect_refusal("rope = []\n", "1:8", "rope", "[[rope]]");
}

TEST(ParseScene, PointsAtNumbersOutOfRange) {
    expect_refusal("[clip]\nframes = 0\n" + rope, "2:10", "frames", "0", "1 to 10000000");
    expect_refusal("[clip]\nframes = 9223372036854775807\n" + rope, "2:10", "1 to 10000000");
    expect_refusal("[clip]\nsteps_per_frame = 1000001\n" + rope, "2:19", "1 to 1000000");
    expect_refusal("[clip]\nsize = [960, 16385]\n" + rope, "2:14", "size", "1 to 16384");
    expect_refusal("[clip]\nframe_time = 0\n" + rope, "2:14", "frame_time");
    expect_refusal("[clip]\nview = { height = -1 }\n" + rope, "2:19", "height");
    expect_refusal("gravity = [0, nan]\n" + rope, "1:15", "gravity", "nan");
    expect_refusal("gravity = [-inf, 0]\n" + rope, "1:12", "gravity", "inf");
    expect_refusal(rope + "nodes = 1\n", "4:9", "nodes", "2 to 1000000");
    expect_refusal(rope + "mass = 0\n", "4:8", "mass");
    expect_refusal(rope + "stiffness = -1\n", "4:13", "stiffness");
    expect_refusal(rope + "rest_length = 0.0\n", "4:15", "rest_length");
    expect_refusal(rope + "damping = -0.1\n", "4:11", "damping");
    expect_refusal(rope + "damping_factor = 1\n", "4:18", "damping_factor", "below 1");
    expect_refusal(rope + "sweeps = 1001\n", "4:10", "sweeps", "1 to 1000");
    expect_refusal(rope + "line_width = 1001\n", "4:14", "line_width", "0 to 1000");
    expect_refusal(rope + "nodes = 3\nmasses = [1, 0, 1]\n", "5:14", "masses");
}

TEST(ParseScene, PointsAtTextsThatWillNotDo) {
    expect_refusal("title = \"a\\u0007b\"\n" + rope, "1:9", "title", "control");
    expect_refusal("title = \"a\\u0085b\"\n" + rope, "1:9", "title", "control");
    expect_refusal("title = \"" + std::string(201, 'x') + "\"\n" + rope, "1:9", "title", "200");
    expect_refusal(rope + "name = \"\"\n", "4:8", "name", "empty");
    for (const char* color :
         {"", "#", "red", "#00ff0", "#00ff000", "00ff000", "#00fg00", "#-00001", "#+00001"})
        expect_refusal(rope + "color = \"" + color + "\"\n", "4:9", "color", "#0080ff");
    expect_refusal(rope + "method = \"symplectic_eular\"\n", "4:10", "symplectic_eular", "stormer_verlet");
}

TEST(ParseScene, PointsAtKeysThatDoNotGoTogether) {
    expect_refusal(rope + "mass = 1\nmasses = [1]\n", "5:10", "masses", "not both");
    expect_refusal(rope + "masses = [1, 2]\n", "4:10", "masses", "2", "16");
    expect_refusal(rope + "masses = []\n", "4:10", "masses", "0", "16");
    expect_refusal(rope + "damping = 0.1\ndamping_factor = 0.1\n", "5:18", "not both");
    expect_refusal(rope + "pinned = [0, 16]\n", "4:10", "pinned", "16", "-16 to 15");
    expect_refusal(rope + "pinned = [0, -16]\n", "4:10", "pinned", "twice");
    expect_refusal("[[rope]]\nstart = [1, 2]\nend = [1, 2]\n", "3:7", "same point");
    expect_refusal("[[rope]]\nstart = [1, 2]\nvia = [[3, 4], [3, 4]]\nend = [5, 6]\n", "3:7", "same point");
    expect_refusal("[[rope]]\nend = [1, 2]\n", "1:1", "start", "missing");
    expect_refusal(rope + "name = \"a\"\n" + rope + "name = \"a\"\n", "8:8", "name", "'a'");
    expect_refusal(rope + rope + "name = \"rope 1\"\n", "7:8", "name", "'rope 1'");
    expect_refusal(rope + "name = \"rope 2\"\n" + rope, "5:1", "name", "'rope 2'");
}

// Links of 400/15 from start to end; over a corner at no node, one link is shorter than the path's.
TEST(ParseScene, PointsAtLengthsThatDirectProjectionCannotKeep) {
    const std::string direct = "method = \"direct_projection\"\n";
    expect_refusal(rope + direct + "rest_length = 10\n", "5:15", "link 0 starts ",
                   "expects its rest length, 10");
    expect_refusal("[[rope]]\nstart = [0, 0]\nvia = [[3, 4]]\nend = [6, 0]\nnodes = 4\n" + direct, "3:7",
                   "link 1 starts 2.0 long", "3.33");
    EXPECT_NO_THROW(parse_scene(
        "[[rope]]\nstart = [0, 0]\nvia = [[3, 4]]\nend = [6, 0]\nnodes = 5\n" + direct, "a.toml"));
}

TEST(ParseScene, SaysThatASceneNeedsARope) {
    expect_refusal("", "1:1", "[[rope]]");
    expect_refusal("title = \"alone\"\n", "1:1", "[[rope]]");
}

TEST(ParseScene, PointsAtWhatIsNoToml) {
    expect_refusal("title = \n" + rope, "1:9", "");
    expect_refusal("title = \"a\"\ntitle = \"b\"\n" + rope, "2:9", "title");
    expect_refusal(rope + "name = \"a\n", "4:10", "");
    expect_refusal("[=]\n" + rope, "1:2", "key");
    expect_refusal("[[[rope]]]\n", "1:3", "key");
    EXPECT_THAT(refusal("title = \"\xff\"\n" + rope), StartsWith("a.toml:1:"));
    EXPECT_THAT(refusal(std::string(100'000, '[')), StartsWith("a.toml:1:"));
    EXPECT_THAT(refusal(std::string(1, '\0')), StartsWith("a.toml:1:"));
}

TEST(ParseScene, DoesNotEchoWhatATerminalWouldObey) {
    EXPECT_THAT(refusal("x = f\bam"), HasSubstr("saw 'f\\x08'"));
}

TEST(ParseScene, RefusesMoreTextThanMemoryHoldsTablesOf) {
    EXPECT_EQ(refusal(std::string(largest_scene + 1, '\n')),
              "a.toml: found 67108865 bytes of scene, expected at most 67108864");
}

// As deep as this, toml++ would overflow the stack when it lets go of the tables.
TEST(ParseScene, RefusesKeysOfAMillionParts) {
    std::string key = "a";
    for (int i = 1; i < 1'000'000; ++i) key += ".a";
    const std::string place = "a.toml:1:";
    EXPECT_THAT(refusal("[" + key + "]\n" + rope), AllOf(StartsWith(place), HasSubstr("100 parts")));
    EXPECT_THAT(refusal(key + " = 1\n" + rope), AllOf(StartsWith(place), HasSubstr("100 parts")));
    EXPECT_THAT(refusal("x = { " + key + " = 1 }\n" + rope),
                AllOf(StartsWith(place), HasSubstr("100 parts")));
}

// The ropes behind the one that is too much are not looked at.
TEST(ParseScene, RefusesARopeTooMuchAtOnce) {
    std::string ropes;
    for (int i = 0; i < 1000; ++i) ropes += "[[rope]]\nstart = [0, 0]\nend = [1e6, 0]\nnodes = 1000000\n";
    expect_refusal(ropes + "[[rope]]\n", "44:9", "11000000 together", "10000000");
}

// A file with a few bytes changed, lost or doubled is read or refused with its place, and nothing else.
TEST(ParseScene, SurvivesDamagedFiles) {
    std::mt19937 engine(1);
    const auto below = [&](std::size_t end) {
        return std::uniform_int_distribution<std::size_t>(0, end - 1)(engine);
    };
    for (const BuiltinScene& builtin : builtin_scenes())
        for (int trial = 0; trial < 300; ++trial) {
            std::string toml(builtin.toml);
            for (std::size_t changes = 1 + below(3); changes > 0; --changes) {
                const std::size_t place = below(toml.size());
                const std::size_t kind = below(3);
                if (kind == 0) toml[place] = static_cast<char>(below(256));
                if (kind == 1) toml.erase(place, 1 + below(9));
                if (kind == 2) toml.insert(place, toml.substr(below(toml.size()), 1 + below(9)));
            }
            const std::string message = refusal(toml);
            EXPECT_THAT(message,
                        testing::AnyOf("accepted", testing::MatchesRegex("a\\.toml:[0-9]+:[0-9]+: .+")))
                << toml;
        }
}

TEST(ParseScene, ReadsFilesFromOtherSystems) {
    EXPECT_EQ(parse_scene("\xef\xbb\xbf[[rope]]\r\nstart = [0, 200]\r\nend = [-400, 200]\r\n", "a"),
              parse_scene(rope, "a"));
}

TEST(ParseScene, KeepsItsMessageOnOneLine) {
    EXPECT_EQ(refusal("\"a\\nb\" = 1\n" + rope).find('\n'), std::string::npos);
    EXPECT_EQ(refusal("title = \n" + rope).find('\n'), std::string::npos);
    EXPECT_EQ(refusal(rope + "method = \"a\\nb\"\n").find('\n'), std::string::npos);
}

}  // namespace
}  // namespace ropesim
