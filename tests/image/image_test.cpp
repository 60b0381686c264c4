#include "image/image.h"

#include <gtest/gtest.h>

namespace ropesim {
namespace {

TEST(Image, FilledIsOneColorEverywhere) {
    const Image image = filled(3, 2, {1, 2, 3});
    ASSERT_EQ(image.rgb.size(), 18U);
    for (int y = 0; y < 2; ++y) {
        for (int x = 0; x < 3; ++x) EXPECT_EQ(pixel(image, x, y), (Color{1, 2, 3}));
    }
}

TEST(Image, RowsGoFromTopToBottomWithoutPadding) {
    Image image = filled(3, 2, {0, 0, 0});
    set_pixel(image, 2, 1, {7, 8, 9});
    EXPECT_EQ(image.rgb, (std::vector<std::uint8_t>{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 7, 8, 9}));
    EXPECT_EQ(pixel(image, 2, 1), (Color{7, 8, 9}));
}

TEST(Image, PastedIsWhereItIsPutAndNowhereElse) {
    Image onto = filled(4, 3, {1, 1, 1});
    Image from = filled(2, 2, {7, 8, 9});
    set_pixel(from, 1, 0, {2, 3, 4});
    paste(from, onto, 2, 1);
    Image expected = filled(4, 3, {1, 1, 1});
    set_pixel(expected, 2, 1, {7, 8, 9});
    set_pixel(expected, 3, 1, {2, 3, 4});
    set_pixel(expected, 2, 2, {7, 8, 9});
    set_pixel(expected, 3, 2, {7, 8, 9});
    EXPECT_EQ(onto, expected);
}

}  // namespace
}  // namespace ropesim
