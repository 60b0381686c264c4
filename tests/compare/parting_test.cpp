#include "compare/parting.h"

#include <gmock/gmock.h>

namespace ropesim {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

// Two ropes that fall freely, the second from three units to the right of the first, on a picture of two
// pixels a unit; and one that explicit Euler blows up.
Scene falling(bool with_explosion) {
    Scene scene;
    scene.frames = 31;
    scene.steps_per_frame = 8;
    scene.size = {100, 100};
    scene.view.height = 50.0;
    for (const double left : {0.0, 3.0}) {
        SceneRope& rope = scene.ropes.emplace_back();
        rope.name = left == 0.0 ? "here" : "there";
        rope.method = "stormer_verlet";
        rope.start = {left, 0.0};
        rope.end = {left + 9.0, 0.0};
        rope.nodes = 10;
        rope.mass = 2.0;
        rope.pinned.clear();
    }
    if (with_explosion) {
        scene.ropes[1].method = "explicit_euler";
        scene.ropes[1].pinned = {0};
    }
    return scene;
}

TEST(Parting, MeasuresPixelsBetweenTheSameMasses) {
    const Parting parts = parting(falling(false));
    ASSERT_EQ(parts.frames.size(), 31u);
    for (const std::vector<ComparedFrame>& runs : parts.frames) {
        ASSERT_TRUE(runs[1].apart);
        EXPECT_NEAR(runs[1].apart->greatest, 6.0, 1e-12);
        EXPECT_NEAR(runs[1].apart->mean, 6.0, 1e-12);
        EXPECT_NEAR(runs[1].farthest, 6.0, 1e-12);
        EXPECT_EQ(runs[0].apart->greatest, 0.0);
    }
}

// What falls freely keeps its energy, here zero at the start.
TEST(Parting, AddsUpEnergy) {
    for (const std::vector<ComparedFrame>& runs : parting(falling(false)).frames)
        EXPECT_NEAR(*runs[0].energy, 0.0, 1e-9);
}

TEST(Parting, EndsWhereARunDiverges) {
    const Parting parts = parting(falling(true));
    ASSERT_TRUE(parts.diverged[1]);
    EXPECT_FALSE(parts.diverged[0]);
    const auto end = static_cast<std::size_t>(*parts.diverged[1]);
    EXPECT_TRUE(parts.frames[end - 1][1].apart);
    EXPECT_FALSE(parts.frames[end][1].apart);
    EXPECT_FALSE(parts.frames[end][1].energy);
    EXPECT_TRUE(parts.frames[end][0].energy);
    EXPECT_EQ(parts.frames.back()[1].farthest, parts.frames[end - 1][1].farthest);
}

TEST(Parting, HasALineOfCsvForEveryFrameAndPair) {
    const Scene scene = falling(true);
    const std::string csv = to_csv(scene, parting(scene));
    EXPECT_THAT(csv,
                StartsWith("frame,rope,against,greatest_px,mean_px,energy,energy_against\n0,there,here,6,"));
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 31);
    EXPECT_THAT(csv, HasSubstr("\n30,there,here,,,,"));
}

TEST(Parting, SaysWhereRunsPart) {
    const Scene scene = falling(false);
    EXPECT_THAT(summaries(scene, parting(scene)),
                ElementsAre(StartsWith("'here' and 'there' part by more than a pixel in frame 0; farthest")));
}

}  // namespace
}  // namespace ropesim
