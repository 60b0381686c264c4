#include "render/clip_segment.h"

#include <gtest/gtest.h>

#include <limits>

namespace ropesim {
namespace {

const Box box = {{-10.0, -5.0}, {10.0, 5.0}};

void expect_clipped(Segment segment, const Segment& expected, double tolerance) {
    ASSERT_TRUE(clip(segment, box));
    EXPECT_LE((segment.begin - expected.begin).abs().maxCoeff(), tolerance) << segment.begin.transpose();
    EXPECT_LE((segment.end - expected.end).abs().maxCoeff(), tolerance) << segment.end.transpose();
}

TEST(Clip, LeavesWhatIsInside) {
    Segment segment{{-9.1, 0.3}, {10.0, 5.0}};
    ASSERT_TRUE(clip(segment, box));
    EXPECT_TRUE((segment.begin == Eigen::Array2d(-9.1, 0.3)).all());
    EXPECT_TRUE((segment.end == Eigen::Array2d(10.0, 5.0)).all());
}

TEST(Clip, CutsWhereTheSegmentCrossesTheSides) {
    expect_clipped({{0.0, 0.0}, {40.0, 10.0}}, {{0.0, 0.0}, {10.0, 2.5}}, 1e-12);
    expect_clipped({{-20.0, -20.0}, {20.0, 20.0}}, {{-5.0, -5.0}, {5.0, 5.0}}, 1e-12);
    expect_clipped({{3.0, 100.0}, {3.0, -100.0}}, {{3.0, 5.0}, {3.0, -5.0}}, 1e-12);
    expect_clipped({{-30.0, 4.0}, {30.0, -8.0}}, {{-10.0, 0.0}, {10.0, -4.0}}, 1e-12);
}

TEST(Clip, RefusesWhatMissesTheBox) {
    for (Segment segment : {Segment{{11.0, 0.0}, {30.0, 1.0}}, Segment{{8.0, 20.0}, {30.0, -2.0}},
                            Segment{{-20.0, 5.1}, {20.0, 5.1}}, Segment{{12.0, 0.0}, {12.0, 0.0}}}) {
        EXPECT_FALSE(clip(segment, box));
    }
}

TEST(Clip, KeepsThePointOfNoLength) {
    expect_clipped({{2.0, 3.0}, {2.0, 3.0}}, {{2.0, 3.0}, {2.0, 3.0}}, 0.0);
}

// The line y = x / 2 passes through the box's opposite corners; far ends may be as far as double goes.
TEST(Clip, IsAccurateForFarEnds) {
    for (const double far : {1e3, 1e6, 1e12, 1e100, 1e300, 0x1p1023}) {
        SCOPED_TRACE(far);
        expect_clipped({{0.0, 0.0}, {far, 0.5 * far}}, {{0.0, 0.0}, {10.0, 5.0}}, 1e-12);
        expect_clipped({{-far, -0.5 * far}, {far, 0.5 * far}}, {{-10.0, -5.0}, {10.0, 5.0}}, 1e-12);
        expect_clipped({{-far, 1.0}, {far, 1.0}}, {{-10.0, 1.0}, {10.0, 1.0}}, 1e-12);
    }
}

// Rounding may decide whether such a line meets the box at all, but never where beyond the box it ends.
TEST(Clip, NeverLeavesTheBox) {
    constexpr double largest = std::numeric_limits<double>::max();
    for (const double a : {largest, 1e300, 3e17, 7e8}) {
        for (const double b : {largest, 2e299, 1e17, 11.0}) {
            Segment segment{{-a, 0.3 * b}, {b, -0.7 * a}};
            if (!clip(segment, box)) continue;
            for (const Eigen::Array2d& point : {segment.begin, segment.end}) {
                EXPECT_TRUE((point >= box.lowest).all() && (point <= box.highest).all()) << point.transpose();
            }
        }
    }
}

}  // namespace
}  // namespace ropesim
