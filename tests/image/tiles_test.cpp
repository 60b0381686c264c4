#include "image/tiles.h"

#include <gtest/gtest.h>

namespace ropesim {
namespace {

constexpr int side = tile_side;

// Three columns, the last half as wide, and two rows, the last a pixel high.
Tiles some() {
    return Tiles(2 * side + side / 2, side + 1);
}

bool same(const PixelBox& a, const PixelBox& b) {
    return a.left == b.left && a.top == b.top && a.right == b.right && a.bottom == b.bottom;
}

TEST(Tiles, CoverThePicture) {
    EXPECT_EQ(some().columns(), 3);
    EXPECT_EQ(some().rows(), 2);
}

TEST(Tiles, AreThoseThatABoxMeets) {
    Tiles tiles = some();
    tiles.add({side, 0, side, 5});  // no pixel
    EXPECT_TRUE(tiles.runs().empty());
    tiles.add({side, side - 1, 2 * side, side});
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 2; ++row)
            EXPECT_EQ(tiles.contains(column, row), column == 1 && row == 0) << column << ' ' << row;
    tiles.add({-5, side, 1, 100 * side});
    EXPECT_TRUE(tiles.contains(0, 1));
    EXPECT_FALSE(tiles.contains(1, 1));
}

TEST(Tiles, AreRunsOfNeighbours) {
    Tiles tiles = some();
    tiles.add({0, 0, 1, 1});
    tiles.add({2 * side, 0, 100 * side, side + 1});
    tiles.add({side, side, side + 1, side + 1});
    const std::vector<PixelBox> runs = tiles.runs();
    ASSERT_EQ(runs.size(), 3U);
    EXPECT_TRUE(same(runs[0], {0, 0, side, side}));
    EXPECT_TRUE(same(runs[1], {2 * side, 0, 2 * side + side / 2, side}));
    EXPECT_TRUE(same(runs[2], {side, side, 2 * side + side / 2, side + 1}));
}

TEST(Tiles, OfTwoAreThoseOfEither) {
    Tiles tiles = some();
    Tiles others = some();
    tiles.add({0, 0, 1, 1});
    others.add({side, side, side + 1, side + 1});
    tiles.add(others);
    EXPECT_EQ(tiles.runs().size(), 2U);
    EXPECT_TRUE(tiles.any_in_rows(0, 1));
    tiles.clear();
    EXPECT_FALSE(tiles.any_in_rows(0, 1));
}

}  // namespace
}  // namespace ropesim
