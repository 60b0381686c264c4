#include "clip/contact_sheet.h"

#include <gtest/gtest.h>

namespace ropesim {
namespace {

constexpr Color black = {0, 0, 0};
constexpr Color red = {255, 0, 0};

// A mass in the middle of a picture of 41 x 21 pixels.
SheetCell mass_in_the_middle(Color color) {
    return {{{Eigen::ArrayX2d::Zero(1, 2), color, 0.0, 9.0}}, {}};
}

TEST(ContactSheet, PutsPicturesSideBySideInRows) {
    const std::vector<std::vector<SheetCell>> rows{{mass_in_the_middle(red), mass_in_the_middle({0, 0, 255})},
                                                   {mass_in_the_middle({0, 255, 0})}};
    const Image sheet = contact_sheet(rows, 41, 21, Camera{{0.0, 0.0}, 21.0}, black);
    EXPECT_EQ(sheet.width, 41 + 2 + 41);
    EXPECT_EQ(sheet.height, 21 + 2 + 21);
    EXPECT_EQ(pixel(sheet, 20, 10), red);
    EXPECT_EQ(pixel(sheet, 43 + 20, 10), (Color{0, 0, 255}));
    EXPECT_EQ(pixel(sheet, 20, 23 + 10), (Color{0, 255, 0}));
    EXPECT_EQ(pixel(sheet, 43 + 20, 23 + 10), black);
    EXPECT_NE(pixel(sheet, 41, 10), black);  // the line between them
    EXPECT_EQ(pixel(sheet, 0, 0), black);
}

}  // namespace
}  // namespace ropesim
