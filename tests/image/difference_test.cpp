#include "image/difference.h"

#include "image/pictures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace ropesim {
namespace {

TEST(Difference, OfEqualPicturesIsNone) {
    const Image image = noise(20, 10, 1);
    const Difference found = difference(image, image);
    EXPECT_EQ(found.pixels, 0);
    EXPECT_EQ(found.largest, 0);
}

TEST(Difference, CountsPixelsAndFindsTheFirstLargest) {
    const Image expected = filled(5, 4, {100, 100, 100});
    Image actual = expected;
    set_pixel(actual, 1, 0, {100, 101, 100});
    set_pixel(actual, 3, 2, {95, 100, 100});
    set_pixel(actual, 0, 3, {100, 105, 95});
    const Difference found = difference(expected, actual);
    EXPECT_EQ(found.pixels, 3);
    EXPECT_EQ(found.largest, 5);
    EXPECT_EQ(found.x, 3);
    EXPECT_EQ(found.y, 2);
}

TEST(Difference, SpansAllOfAByte) {
    EXPECT_EQ(difference(filled(1, 1, {0, 0, 0}), filled(1, 1, {0, 0, 255})).largest, 255);
    EXPECT_EQ(difference(filled(1, 1, {255, 0, 0}), filled(1, 1, {0, 0, 0})).largest, 255);
}

TEST(Difference, RefusesOtherSizesAndNamesBoth) {
    const Image expected = filled(4, 3, {0, 0, 0});
    const Image actual = filled(3, 4, {0, 0, 0});
    EXPECT_THAT([&] { difference(expected, actual); },
                testing::ThrowsMessage<std::runtime_error>(
                    testing::AllOf(testing::HasSubstr("found 3x4"), testing::HasSubstr("expected 4x3"))));
    EXPECT_THROW(difference_picture(expected, actual), std::runtime_error);
}

TEST(DifferencePicture, IsRedForWhatIsMissingAndGreenForWhatIsExtra) {
    const Image background = filled(2, 1, {0, 0, 0});
    Image expected = background;
    Image actual = background;
    set_pixel(expected, 0, 0, {0, 0, 255});
    set_pixel(actual, 1, 0, {0, 0, 255});
    const Image picture = difference_picture(expected, actual);
    EXPECT_EQ(pixel(picture, 0, 0), (Color{255, 0, 0}));
    EXPECT_EQ(pixel(picture, 1, 0), (Color{0, 255, 0}));
}

TEST(DifferencePicture, ShowsADifferenceOfOneBrighterThanAnythingThatAgrees) {
    Image expected = filled(2, 1, {255, 255, 255});
    Image actual = expected;
    set_pixel(actual, 1, 0, {255, 254, 255});
    const Image picture = difference_picture(expected, actual);
    EXPECT_LT(pixel(picture, 0, 0)[0], 100);
    EXPECT_GE(pixel(picture, 1, 0)[0], 128);
    EXPECT_EQ(pixel(picture, 1, 0)[1], 0);
}

}  // namespace
}  // namespace ropesim
