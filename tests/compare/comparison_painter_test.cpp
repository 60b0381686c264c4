#include "compare/comparison_painter.h"

#include "compare/comparison_chart.h"

#include <gmock/gmock.h>

namespace ropesim {
namespace {

constexpr Color black = {0, 0, 0};
constexpr Color red = {255, 0, 0};
constexpr Color blue = {0, 0, 255};

// Two ropes of two masses on a picture of 101 x 101 pixels, a pixel a unit; the second is `above` the first.
struct TwoRopes {
    Scene scene;
    Parting parts;
    std::vector<Points> positions;
};

TwoRopes two_ropes(double above) {
    TwoRopes two;
    two.scene.frames = 2;
    two.scene.size = {101, 101};
    two.scene.view.height = 101.0;
    two.scene.words = false;
    for (const char* name : {"a", "b"}) {
        SceneRope& rope = two.scene.ropes.emplace_back();
        rope.name = name;
        rope.nodes = 2;
        rope.start = {-30.0, 0.0};
        rope.end = {30.0, 0.0};
        rope.color = two.scene.ropes.size() == 1 ? red : blue;
        Points points(2, 2);
        points << -30.0, two.positions.empty() ? 0.0 : above, 30.0, two.positions.empty() ? 0.0 : above;
        two.positions.push_back(points);
    }
    two.parts = parting(two.scene);
    return two;
}

TEST(ComparisonPainter, JoinsMassesThatAreMoreThanAPixelApart) {
    const TwoRopes apart = two_ropes(-40.0);
    ComparisonPainter painter(apart.scene, apart.parts, Layout::overlay);
    const Image picture = painter.draw(1, apart.positions);
    EXPECT_EQ(pixel(picture, 50, 50), red);
    EXPECT_EQ(pixel(picture, 50, 90), blue);
    EXPECT_NE(pixel(picture, 20, 70), black);  // between the first masses
    EXPECT_EQ(pixel(picture, 50, 70), black);
    const TwoRopes together = two_ropes(-0.9);
    ComparisonPainter other(together.scene, together.parts, Layout::overlay);
    EXPECT_EQ(pixel(other.draw(1, together.positions), 20, 70), black);
}

TEST(ComparisonPainter, GivesEachRunAPanel) {
    const TwoRopes two = two_ropes(-40.0);
    ComparisonPainter painter(two.scene, two.parts, Layout::side_by_side);
    const Image picture = painter.draw(1, two.positions);
    EXPECT_EQ(picture.width, 101 + 2 + 101);
    EXPECT_EQ(picture.height, 101);
    EXPECT_EQ(pixel(picture, 50, 50), red);
    EXPECT_EQ(pixel(picture, 50, 90), black);
    EXPECT_EQ(pixel(picture, 103 + 50, 90), blue);
    EXPECT_EQ(pixel(picture, 103 + 50, 50), black);
}

TEST(ComparisonPainter, ShowsInRedAndGreenWhatOnlyOneDraws) {
    const TwoRopes two = two_ropes(-40.0);
    ComparisonPainter painter(two.scene, two.parts, Layout::difference);
    const Image picture = painter.draw(1, two.positions);
    EXPECT_EQ(picture.width, 101);
    EXPECT_EQ(pixel(picture, 50, 50), red);
    EXPECT_EQ(pixel(picture, 50, 90), (Color{0, 255, 0}));
    EXPECT_EQ(pixel(picture, 50, 70), black);
}

TEST(ComparisonPainter, LeavesOutARunThatHasDiverged) {
    TwoRopes two = two_ropes(-40.0);
    two.positions[1].resize(0, 2);
    for (const Layout layout : {Layout::overlay, Layout::side_by_side, Layout::difference}) {
        ComparisonPainter painter(two.scene, two.parts, layout);
        EXPECT_EQ(pixel(painter.draw(1, two.positions), 50, 50), red);
    }
}

TEST(Strip, PutsFramesInRowsOfThree) {
    const TwoRopes two = two_ropes(-40.0);
    const Image figure = strip(two.scene, two.parts, {0, 0, 1, 1}, std::vector(4, two.positions));
    EXPECT_EQ(figure.width, 2 * 101 + 2);  // four are two and two
    EXPECT_EQ(figure.height, 2 * 101 + 2);
    EXPECT_EQ(pixel(figure, 103 + 50, 103 + 90), blue);
}

TEST(ComparisonScript, QuotesNamesForGnuplot) {
    TwoRopes two = two_ropes(-40.0);
    two.scene.ropes[1].name = "it's `id`";
    EXPECT_THAT(comparison_script(two.scene, two.parts), testing::HasSubstr("label[1] = 'it''s `id`: "));
}

}  // namespace
}  // namespace ropesim
