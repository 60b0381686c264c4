#include "clip/positions.h"

#include "clip/positions_writer.h"
#include "clip/some_positions.h"

#include <gmock/gmock.h>

namespace ropesim {
namespace {

using testing::HasSubstr;

TEST(PositionsCsv, ReadsBackAsTheSameBits) {
    const Scene scene = scene_of({{"Euler", 3}, {"a \"quoted\", name", 5}});
    const Positions positions = random_positions(scene, 10);
    expect_same_bits(positions, parse_positions(scene, to_csv(scene, positions), "csv"));
}

TEST(PositionsCsv, IsLinesOfFrameRopeNodeXY) {
    const Scene scene = scene_of({{"a,b", 2}});
    Points points(2, 2);
    points << 0.1, -2.0, 1e300, 0.0;
    EXPECT_EQ(
        to_csv(scene, {{3, {points}}}),
        "frame,rope,node,x,y\n3,\"a,b\",0,0.10000000000000001,-2\n3,\"a,b\",1,1.0000000000000001e+300,0\n");
}

TEST(PositionsCsv, IsTheSameWrittenFrameByFrame) {
    const Scene scene = scene_of({{"a,b", 2}, {"c", 3}});
    const Positions positions = random_positions(scene, 5);
    EXPECT_EQ(written(".csv", scene, positions), to_csv(scene, positions));
}

TEST(PositionsCsv, LeavesOutARopeThatDiverged) {
    const Scene scene = scene_of({{"a", 2}, {"b", 2}});
    Positions positions = random_positions(scene, 2);
    positions[1][0] = Points(0, 2);
    const Positions again = parse_positions(scene, to_csv(scene, positions), "csv");
    expect_same_bits(positions, again);
}

TEST(PositionsCsv, ReadsLinesThatEndAsOnWindows) {
    const Scene scene = scene_of({{"a", 2}});
    const Positions positions =
        parse_positions(scene, "frame,rope,node,x,y\r\n0,a,0,1,2\r\n0,a,1,3,4\r\n", "csv");
    EXPECT_EQ(positions.at(0)[0](1, 1), 4.0);
}

TEST(PositionsCsv, RefusesWithFileAndLine) {
    const Scene scene = scene_of({{"a", 2}});
    const std::string begin = "frame,rope,node,x,y\n0,a,0,1,2\n";
    EXPECT_THAT(refusal(scene, "frame,x,y\n"),
                HasSubstr("swing.csv:1: expected the line frame,rope,node,x,y"));
    EXPECT_THAT(refusal(scene, begin), HasSubstr("swing.csv:3: the file ends within a rope"));
    EXPECT_THAT(refusal(scene, begin + "0,a,1,1,x\n"),
                HasSubstr("swing.csv:3: found 'x', expected a number"));
    EXPECT_THAT(refusal(scene, begin + "0,a,1,1,nan\n"),
                HasSubstr("swing.csv:3: a coordinate is not finite"));
    EXPECT_THAT(refusal(scene, begin + "0,a,2,1,2\n"), HasSubstr("expected frame 0, rope 'a', node 1"));
    EXPECT_THAT(refusal(scene, begin + "0,a,1,1\n"), HasSubstr("swing.csv:3: expected frame,rope,node,x,y"));
    EXPECT_THAT(refusal(scene, "frame,rope,node,x,y\n0,b,0,1,2\n"), HasSubstr("the scene has no rope 'b'"));
    EXPECT_THAT(refusal(scene, "frame,rope,node,x,y\n10,a,0,1,2\n"), HasSubstr("0 to 9"));
    EXPECT_THAT(refusal(scene, begin + "0,a,1,1,2\n0,a,0,1,2\n0,a,1,1,2\n"), HasSubstr("stands twice"));
}

TEST(PositionsCsv, ReadsFilesThatBeginWithAByteOrderMark) {
    const Scene scene = scene_of({{"a", 2}});
    const Positions positions = parse_positions(scene,
                                                "\xef\xbb\xbf"
                                                "frame,rope,node,x,y\n0,a,0,1,2\n0,a,1,3,4\n",
                                                "csv");
    EXPECT_EQ(positions.at(0)[0](1, 1), 4.0);
}

TEST(PositionsCsv, RefusesNumbersBeyondDoubles) {
    const Scene scene = scene_of({{"a", 2}});
    for (const std::string number : {"1e400", "-1e400", "inf", "nan", "", "1,5", "0x1p3", "1.5 ", "+1"})
        EXPECT_NE(refusal(scene, "frame,rope,node,x,y\n0,a,0,1," + number + "\n0,a,1,3,4\n"), "") << number;
    EXPECT_EQ(refusal(scene, "frame,rope,node,x,y\n0,a,0,-0,5e-324\n0,a,1,1e308,-1e-310\n"), "");
}

TEST(PositionsCsv, DoesNotEchoWhatATerminalWouldObey) {
    const Scene scene = scene_of({{"a", 2}});
    EXPECT_THAT(refusal(scene, "frame,rope,node,x,y\n0,\x1b[31m,0,1,2\n"), HasSubstr("no rope '\\x1b[31m'"));
    EXPECT_THAT(refusal(scene, "frame,rope,node,x,y\n0,a,0,1,\x1b[31m\n"), HasSubstr("found '\\x1b[31m'"));
}

// A hundred bytes a frame would take 24 MB of memory each.
TEST(Positions, RefuseMoreRopesInMoreFramesThanMemoryHolds) {
    Scene scene = scene_of(std::vector<std::pair<std::string, int>>(1 << 20, {"a", 2}));
    scene.frames = 1000;
    std::string csv = "frame,rope,node,x,y\n";
    for (int frame = 0; frame < 100; ++frame)
        for (int node = 0; node < 2; ++node)
            csv += std::to_string(frame) + ",a," + std::to_string(node) + ",0,0\n";
    EXPECT_THAT(refusal(scene, csv), HasSubstr("swing.csv:130: found too many ropes in too many frames"));

    scene = scene_of(std::vector<std::pair<std::string, int>>(1 << 14, {"a", 2}));
    scene.frames = 5000;
    std::string npy = npy_header(4097, 2) + std::string(4097 * 2 * 2 * sizeof(double), '\0');
    for (std::size_t rope = 1; rope < scene.ropes.size(); ++rope) npy += npy_header(0, 2);
    EXPECT_THAT(refusal(scene, npy), HasSubstr("swing.csv: found too many ropes in too many frames"));
}

}  // namespace
}  // namespace ropesim
