#include "diff/pixels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ropesim {
namespace {

TEST(PixelDifference, OfEqualPicturesIsNone) {
    EXPECT_EQ(pixel_difference(filled(3, 2, {1, 2, 3}), filled(3, 2, {1, 2, 3}), 0), PixelDifference());
}

TEST(PixelDifference, CountsWhatIsBeyondTheThresholdAndWhereItIs) {
    const Image expected = filled(10, 8, {100, 100, 100});
    Image actual = expected;
    set_pixel(actual, 0, 0, {102, 98, 100});
    set_pixel(actual, 4, 3, {100, 100, 103});
    set_pixel(actual, 7, 5, {50, 100, 100});
    const PixelDifference found = pixel_difference(expected, actual, 2);
    EXPECT_EQ(found.changed, 3);
    EXPECT_EQ(found.over, 2);
    EXPECT_EQ(found.largest, 50);
    EXPECT_EQ(found.region, (Region{4, 3, 7, 5}));
}

TEST(PixelDifference, HasTheRegionOfAllThatChangedWhereNothingIsBeyondTheThreshold) {
    const Image expected = filled(10, 8, {0, 0, 0});
    Image actual = expected;
    set_pixel(actual, 2, 6, {0, 1, 0});
    const PixelDifference found = pixel_difference(expected, actual, 2);
    EXPECT_EQ(found.over, 0);
    EXPECT_EQ(found.region, (Region{2, 6, 2, 6}));
}

TEST(PixelDifference, CountsAsDrawnWhatIsNotBackgroundInEitherPicture) {
    Image expected = filled(10, 8, {9, 9, 9});
    Image actual = expected;
    set_pixel(expected, 1, 0, {0, 0, 0});  // in rows that agree, too
    set_pixel(actual, 1, 0, {0, 0, 0});
    set_pixel(expected, 3, 4, {9, 9, 8});
    set_pixel(actual, 5, 4, {255, 9, 9});
    set_pixel(expected, 6, 4, {1, 1, 1});
    set_pixel(actual, 6, 4, {2, 2, 2});
    set_pixel(expected, 8, 4, {200, 9, 9});
    set_pixel(actual, 8, 4, {0, 200, 9});
    const PixelDifference found = pixel_difference(expected, actual, 0);
    EXPECT_EQ(found.drawn, 5);
    EXPECT_EQ(found.over, 4);
    EXPECT_EQ(found.gone, 1);
    EXPECT_EQ(found.added, 1);
}

TEST(PixelDifference, RefusesOtherSizesAndNamesBoth) {
    EXPECT_THAT([] { pixel_difference(filled(4, 3, {}), filled(3, 4, {}), 2); },
                testing::ThrowsMessage<std::runtime_error>(
                    testing::AllOf(testing::HasSubstr("found 3x4"), testing::HasSubstr("expected 4x3"))));
}

TEST(Background, IsTheMostFrequentColour) {
    Image image = filled(3, 3, {1, 1, 1});
    for (int x = 0; x < 3; ++x) set_pixel(image, x, 0, {5, 5, 5});
    EXPECT_EQ(background(image), (Color{1, 1, 1}));
    for (int x = 0; x < 3; ++x) set_pixel(image, x, 2, {5, 5, 5});
    EXPECT_EQ(background(image), (Color{5, 5, 5}));
}

}  // namespace
}  // namespace ropesim
