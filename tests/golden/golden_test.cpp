#include "golden/golden_case.h"

#include "image/difference.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <utility>

namespace ropesim {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::vector<long> frames_of(const GoldenCase& golden) {
    std::vector<long> frames;
    for (const auto& [frame, picture] : golden.pictures) frames.push_back(frame);
    return frames;
}

std::string identifier(std::string name) {
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

class Golden : public testing::TestWithParam<std::string> {};

TEST_P(Golden, PositionsAndPicturesAreThoseStored) {
    const GoldenCase expected = stored(GetParam());
    const GoldenCase actual = made(GetParam(), expected.scene, frames_of(expected));
    const GoldenVerdict verdict = compare(expected, actual);
    EXPECT_THAT(verdict.positions, IsEmpty());
    EXPECT_THAT(verdict.pixels, IsEmpty());
    if (HasFailure()) FAIL() << "report: " << leave_report(actual, ROPESIM_GOLDEN_FAILURES).string();
}

TEST_P(Golden, HoldsThreeToFiveFramesWithPositions) {
    const GoldenCase golden = stored(GetParam());
    EXPECT_GE(golden.pictures.size(), 3u);
    EXPECT_LE(golden.pictures.size(), 5u);
    for (const auto& [frame, picture] : golden.pictures)
        EXPECT_TRUE(golden.positions.contains(frame)) << frame;
}

INSTANTIATE_TEST_SUITE_P(Cases, Golden, testing::ValuesIn(golden_cases()),
                         [](const auto& test) { return identifier(test.param); });

// The same comparison, given something that is wrong, says so: these are the ways in which a golden test
// that is too lenient lets a fault pass.
class GoldenCanFail : public testing::Test {
  protected:
    const GoldenCase expected = stored("seed");
    const long frame = expected.pictures.rbegin()->first;
    GoldenCase actual = expected;

    void draw_again(const Scene& scene, const std::vector<Points>& ropes) {
        actual.pictures[frame] = drawn(scene, ropes);
    }
};

TEST_F(GoldenCanFail, AgreesWithItself) {
    draw_again(expected.scene, expected.positions.at(frame));
    const GoldenVerdict verdict = compare(expected, actual);
    EXPECT_THAT(verdict.positions, IsEmpty());
    EXPECT_THAT(verdict.pixels, IsEmpty());
}

TEST_F(GoldenCanFail, SeesThatAMassMovedByAQuarterPixel) {
    actual.positions.at(frame)[1](7, 0) += 0.25;
    GoldenVerdict verdict = compare(expected, actual);
    EXPECT_THAT(verdict.positions, HasSubstr("mass 7 of rope 'Verlet'"));
    EXPECT_THAT(verdict.positions, HasSubstr("by 0.25"));
    EXPECT_THAT(verdict.pixels, IsEmpty()) << "only the positions moved";
    draw_again(expected.scene, actual.positions.at(frame));
    actual.positions = expected.positions;
    verdict = compare(expected, actual);
    EXPECT_THAT(verdict.positions, IsEmpty()) << "only the pixels changed";
    EXPECT_THAT(verdict.pixels, HasSubstr("in frame " + std::to_string(frame)));
}

TEST_F(GoldenCanFail, SeesTheLastBitOfAPosition) {
    double& x = actual.positions.at(frame)[0](15, 0);
    x = std::nextafter(x, 1e9);
    EXPECT_THAT(compare(expected, actual).positions, HasSubstr("mass 15 of rope 'Euler'"));
}

TEST_F(GoldenCanFail, SeesThatALinkIsMissing) {
    Scene scene = expected.scene;
    std::vector<Points> ropes = expected.positions.at(frame);
    scene.ropes.push_back(scene.ropes[1]);
    ropes.push_back(ropes[1].bottomRows(8));
    ropes[1] = Points(ropes[1].topRows(8));
    scene.words = false;
    actual.pictures[frame] = drawn(scene, ropes);
    GoldenCase whole = expected;
    Scene wordless = expected.scene;
    wordless.words = false;
    whole.pictures[frame] = drawn(wordless, expected.positions.at(frame));
    EXPECT_THAT(compare(whole, actual).pixels, HasSubstr("in frame " + std::to_string(frame)));
}

TEST_F(GoldenCanFail, SeesThatTwoColoursAreSwapped) {
    Scene scene = expected.scene;
    std::swap(scene.ropes[0].color, scene.ropes[1].color);
    draw_again(scene, expected.positions.at(frame));
    EXPECT_THAT(compare(expected, actual).pixels, Not(IsEmpty()));
}

TEST_F(GoldenCanFail, SeesThatTheClipIsOneFrameLate) {
    const GoldenCase late = made("seed", expected.scene, {frame - 1});
    actual.positions[frame] = late.positions.at(frame - 1);
    actual.pictures[frame] = late.pictures.at(frame - 1);
    const GoldenVerdict verdict = compare(expected, actual);
    EXPECT_THAT(verdict.positions, Not(IsEmpty()));
    EXPECT_THAT(verdict.pixels, Not(IsEmpty()));
}

TEST_F(GoldenCanFail, SeesThatALineIsHalfAPixelTooWide) {
    Scene scene = expected.scene;
    scene.ropes[0].line_width += 0.5;
    draw_again(scene, expected.positions.at(frame));
    EXPECT_THAT(compare(expected, actual).pixels, Not(IsEmpty()));
}

TEST_F(GoldenCanFail, SeesThatAFrameIsGone) {
    actual.pictures.erase(frame);
    actual.positions.erase(frame);
    const GoldenVerdict verdict = compare(expected, actual);
    EXPECT_THAT(verdict.positions, HasSubstr("no positions"));
    EXPECT_THAT(verdict.pixels, HasSubstr("no picture"));
}

class GoldenComparison : public testing::TestWithParam<std::string> {};

TEST_P(GoldenComparison, IsThePictureStored) {
    const Image expected = stored_comparison(GetParam());
    const Image actual = made_comparison(GetParam());
    ASSERT_EQ(expected.width, actual.width);
    ASSERT_EQ(expected.height, actual.height);
    EXPECT_EQ(difference(expected, actual).pixels, 0);
}

INSTANTIATE_TEST_SUITE_P(Layouts, GoldenComparison, testing::ValuesIn(comparison_layouts()),
                         [](const auto& test) { return identifier(test.param); });

}  // namespace
}  // namespace ropesim
