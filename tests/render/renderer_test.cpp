#include "render/renderer.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace ropesim {
namespace {

constexpr Color black = {0, 0, 0};
constexpr Color white = {255, 255, 255};
constexpr int width = 64;
constexpr int height = 48;

// One world unit is one pixel, the origin at the picture's centre.
constexpr double half_width = width / 2;
constexpr double half_height = height / 2;
const Camera plain = {{0.0, 0.0}, height};

Polyline line(std::initializer_list<Eigen::Array2d> points, double line_width, double point_size) {
    Polyline polyline;
    polyline.points.resize(static_cast<Eigen::Index>(points.size()), 2);
    Eigen::Index row = 0;
    for (const Eigen::Array2d& point : points) polyline.points.row(row++) = point;
    polyline.line_width = line_width;
    polyline.point_size = point_size;
    return polyline;
}

Image drawn(const std::vector<Polyline>& polylines, Color background = black) {
    return Renderer(width, height, plain, background, {}).draw(polylines);
}

double distance(const Eigen::Array2d& point, const Eigen::Array2d& begin, const Eigen::Array2d& end) {
    const Eigen::Vector2d along = (end - begin).matrix();
    const Eigen::Vector2d from_begin = (point - begin).matrix();
    const double square = along.squaredNorm();
    const double part = square > 0.0 ? std::clamp(from_begin.dot(along) / square, 0.0, 1.0) : 0.0;
    return (from_begin - part * along).norm();
}

// The greatest coverage, by the formula of renderer.h, that any link or mass has at a pixel.
double coverage(const Polyline& polyline, int column, int row) {
    const Eigen::Array2d center(column + 0.5 - half_width, half_height - row - 0.5);
    double greatest = 0.0;
    const auto cover = [&](Eigen::Index first, Eigen::Index last, double diameter) {
        const double d = distance(center, polyline.points.row(first), polyline.points.row(last));
        if (diameter > 0.0) greatest = std::max(greatest, std::clamp(0.5 * diameter + 0.5 - d, 0.0, 1.0));
    };
    for (Eigen::Index i = 0; i < polyline.points.rows(); ++i) {
        cover(i, i, polyline.point_size);
        if (i > 0) cover(i - 1, i, polyline.line_width);
    }
    return greatest;
}

// A rounding of the coverage to a byte, and one of the mixed colour.
constexpr double byte_tolerance = 1.01;

void expect_coverage(const Polyline& polyline) {
    const Image image = drawn({polyline});
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            const double expected = 255.0 * coverage(polyline, column, row);
            ASSERT_NEAR(pixel(image, column, row)[0], expected, byte_tolerance) << column << ", " << row;
        }
    }
}

TEST(Coverage, OfAHorizontalLine) {
    expect_coverage(line({{-20.0, 3.25}, {17.5, 3.25}}, 4.0, 0.0));
}
TEST(Coverage, OfAVerticalLine) {
    expect_coverage(line({{5.1, -13.0}, {5.1, 16.2}}, 3.0, 0.0));
}
TEST(Coverage, OfASlantedLine) {
    expect_coverage(line({{-21.0, -13.3}, {18.0, 11.7}}, 5.5, 0.0));
}
TEST(Coverage, OfAHairline) {
    expect_coverage(line({{-21.0, 13.3}, {18.0, -11.7}}, 0.5, 0.0));
}
TEST(Coverage, OfAPoint) {
    expect_coverage(line({{2.3, -4.8}}, 4.0, 9.0));
}
// Links shorter than masses are wide, some of which need not be drawn.
TEST(Coverage, OfMassesCloseTogether) {
    for (const double apart : {0.1, 0.9, 1.0, 1.1, 2.0, 3.0}) {
        Polyline chain = line({}, 4.0, 6.0);
        chain.points.resize(20, 2);
        for (int i = 0; i < 20; ++i) chain.points.row(i) << 0.7 * apart * i - 12.0, 5.0 - 0.6 * apart * i;
        expect_coverage(chain);
        chain.point_size = 4.0;
        expect_coverage(chain);
    }
}
TEST(Coverage, OfACoveredPicture) {
    expect_coverage(line({{2.3, -4.8}}, 4.0, 300.0));
}
TEST(Coverage, OfALineOfNoLength) {
    expect_coverage(line({{2.0, 3.0}, {2.0, 3.0}}, 7.0, 0.0));
}

// Links and masses that overlap: at every pixel the nearest counts, once.
TEST(Coverage, OfAChainIsThatOfItsNearestLink) {
    expect_coverage(line({{-20.0, 3.0}, {0.0, 3.2}, {20.0, 3.0}}, 3.0, 0.0));
    expect_coverage(line({{-20.0, -8.0}, {3.1, 9.4}, {2.7, -15.0}, {-22.0, 8.0}}, 2.5, 6.0));
}

TEST(Coverage, OfAChainThatRetracesItselfIsThatOfOneLink) {
    expect_coverage(line({{-20.0, 3.3}, {20.0, -3.3}, {-20.0, 3.3}, {20.0, -3.3}}, 2.0, 0.0));
}

// Interpolated points lie on the line to within rounding, which moves no byte by more than one.
TEST(Coverage, OfAStraightChainIsThatOfOneLink) {
    const Eigen::Array2d begin(-22.0, -14.0);
    const Eigen::Array2d end(23.0, 9.0);
    Polyline chain = line({}, 4.0, 0.0);
    chain.points.resize(40, 2);
    for (int i = 0; i < 40; ++i) chain.points.row(i) = begin + (end - begin) * (i / 39.0);
    const Image expected = drawn({line({begin, end}, 4.0, 0.0)});
    const Image actual = drawn({chain});
    for (std::size_t i = 0; i < expected.rgb.size(); ++i) ASSERT_NEAR(expected.rgb[i], actual.rgb[i], 1);
}

TEST(Coverage, IsThatOfTheWorldSeenByTheCamera) {
    Polyline polyline = line({{-20.0, 3.0}, {5.0, 9.0}}, 3.0, 7.0);
    const Image expected = drawn({polyline});
    polyline.points = polyline.points / 8.0;
    polyline.points.col(0) += 100.0;
    polyline.points.col(1) -= 50.0;
    EXPECT_EQ(Renderer(width, height, {{100.0, -50.0}, height / 8.0}, black, {}).draw({{polyline}}),
              expected);
}

TEST(Colors, AreExactWhereAPixelIsCovered) {
    for (const Color color : {Color{0, 0, 255}, Color{1, 2, 3}, Color{127, 128, 129}, Color{254, 77, 200}}) {
        for (const Color background : {black, white, Color{10, 128, 201}}) {
            Polyline polyline = line({{-10.0, 0.0}, {10.0, 0.0}}, 9.0, 0.0);
            polyline.color = color;
            const Image image = drawn({polyline}, background);
            EXPECT_EQ(pixel(image, width / 2, height / 2), color);
            EXPECT_EQ(pixel(image, 2, 2), background);
        }
    }
}

TEST(Colors, MixWithTheBackgroundByCoverage) {
    Polyline polyline = line({{-20.0, 0.25}, {20.0, 0.25}}, 2.0, 0.0);
    polyline.color = {200, 0, 100};
    // The centre of this pixel is 1.25 away from the line: a quarter is covered.
    const Color mixed = pixel(drawn({polyline}, {0, 100, 40}), width / 2, height / 2 - 2);
    EXPECT_NEAR(mixed[0], 50.0, byte_tolerance);
    EXPECT_NEAR(mixed[1], 75.0, byte_tolerance);
    EXPECT_NEAR(mixed[2], 55.0, byte_tolerance);
}

TEST(Ropes, AreDrawnInTheirOrder) {
    Polyline flat = line({{-20.0, 0.0}, {20.0, 0.0}}, 8.0, 0.0);
    Polyline upright = line({{0.0, -20.0}, {0.0, 20.0}}, 8.0, 0.0);
    flat.color = {0, 0, 255};
    upright.color = {0, 255, 0};
    EXPECT_EQ(pixel(drawn({flat, upright}), width / 2, height / 2), upright.color);
    EXPECT_EQ(pixel(drawn({upright, flat}), width / 2, height / 2), flat.color);
    EXPECT_EQ(pixel(drawn({upright, flat}), width / 2, height / 2 - 15), upright.color);
}

// A later rope mixes with an earlier one, not with the background behind it.
TEST(Ropes, MixWithWhatIsUnderThem) {
    Polyline wide = line({{0.0, 0.0}}, 0.0, 40.0);
    Polyline faint = line({{-20.0, 0.5}, {20.0, 0.5}}, 0.5, 0.0);
    wide.color = {0, 0, 200};
    faint.color = {200, 0, 0};
    const Color mixed = pixel(drawn({wide, faint}), width / 2, height / 2 - 1);
    EXPECT_NEAR(mixed[0], 150.0, byte_tolerance);
    EXPECT_NEAR(mixed[2], 50.0, byte_tolerance);
}

TEST(Ropes, OfNoWidthAreNotDrawn) {
    const Image empty = filled(width, height, black);
    EXPECT_EQ(drawn({line({{-20.0, 0.0}, {20.0, 5.0}}, 0.0, 0.0)}), empty);
    EXPECT_EQ(drawn({line({}, 4.0, 8.0)}), empty);
    EXPECT_EQ(drawn({}), empty);
    const Image masses = drawn({line({{-20.0, 0.0}, {20.0, 0.0}}, 0.0, 8.0)});
    EXPECT_EQ(pixel(masses, width / 2 - 20, height / 2), white);
    EXPECT_EQ(pixel(masses, width / 2, height / 2), black);
}

// What lies beyond the picture by more than its own width changes no pixel, however far it goes.
TEST(FarCoordinates, GiveThePictureOfTheNearPart) {
    for (const double far : {100.0, 1e6, 1e12, 1e100, 1e300, 0x1p1023}) {
        SCOPED_TRACE(far);
        const auto reaching = [](double x) {
            return line({{-3.0, -5.0}, {x - 3.0, 0.5 * x - 5.0}, {x, 3.0 * x}, {-x, 3.0 * x}, {-5.0, x}}, 4.0,
                        8.0);
        };
        const Image expected = drawn({reaching(64.0)});
        const Image actual = drawn({reaching(far)});
        for (int row = height / 4; row < height; ++row) {
            for (int column = 0; column < width; ++column) {
                ASSERT_NEAR(pixel(actual, column, row)[0], pixel(expected, column, row)[0], 1)
                    << column << ' ' << row;
            }
        }
    }
}

TEST(FarCoordinates, OfALineThroughThePictureCrossIt) {
    for (const double far : {100.0, 1e6, 1e12, 1e100, 1e300, 0x1p1023}) {
        SCOPED_TRACE(far);
        const Image expected = drawn({line({{-30.0, -30.0}, {30.0, 30.0}}, 4.0, 0.0)});
        EXPECT_EQ(drawn({line({{-far, -far}, {far, far}}, 4.0, 0.0)}), expected);
    }
}

TEST(FarCoordinates, OutsideThePictureShowNothing) {
    for (const double far : {40.0, 1e6, 1e12, 1e300}) {
        EXPECT_EQ(drawn({line({{far, 0.0}, {far, far}, {-far, far}}, 4.0, 8.0)}),
                  filled(width, height, black));
    }
}

TEST(FarCoordinates, ThatAreNotFiniteEndTheRope) {
    const Image expected = drawn({line({{-20.0, 0.0}, {0.0, 5.0}}, 4.0, 8.0)});
    for (const double bad :
         {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
          std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_EQ(drawn({line({{-20.0, 0.0}, {0.0, 5.0}, {bad, 0.0}, {20.0, 0.0}}, 4.0, 8.0)}), expected);
        EXPECT_EQ(drawn({line({{-20.0, 0.0}, {0.0, 5.0}, {0.0, bad}, {20.0, 0.0}}, 4.0, 8.0)}), expected);
        EXPECT_EQ(drawn({line({{bad, 0.0}, {0.0, 5.0}}, 4.0, 8.0)}), filled(width, height, black));
    }
}

const std::vector<Words> title = {{"Rope", white}, {"64", {0, 255, 0}}};

// Letters of ten pixels, five from the picture's edges. DejaVu Sans reaches 0.93 of that above the
// baseline and 0.24 below.
constexpr int line_height = 10 + 3;

TEST(WordsOnThePicture, StandInTheTopLeftCorner) {
    const Image image = Renderer(width, height, plain, black, title).draw({});
    int left = width;
    int right = 0;
    int top = height;
    int bottom = 0;
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            if (pixel(image, column, row) == black) continue;
            left = std::min(left, column);
            right = std::max(right, column);
            top = std::min(top, row);
            bottom = std::max(bottom, row);
        }
    }
    EXPECT_GE(left, 5);
    EXPECT_LE(left, 7);
    EXPECT_GE(right, 20);
    EXPECT_LE(right, 40);
    EXPECT_GE(top, 5);
    EXPECT_LE(top, 9);
    EXPECT_GE(bottom, 20);
    EXPECT_LE(bottom, 30);
}

TEST(WordsOnThePicture, AreInTheirColors) {
    const Image image = Renderer(width, height, plain, black, title).draw({});
    Color brightest = black;
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            const Color color = pixel(image, column, row);
            const bool grey = color[0] == color[1] && color[1] == color[2];
            const bool green = color[0] == 0 && color[2] == 0;
            ASSERT_TRUE(row < 5 + line_height ? grey : green) << column << ' ' << row;
            for (std::size_t i = 0; i < 3; ++i) brightest[i] = std::max(brightest[i], color[i]);
        }
    }
    EXPECT_GT(brightest[0], 200);
    EXPECT_GT(brightest[1], 200);
}

TEST(WordsOnThePicture, StandOverTheRopes) {
    Polyline blue = line({{0.0, 0.0}}, 4.0, 1000.0);
    blue.color = {0, 0, 255};
    EXPECT_EQ(Renderer(width, height, plain, black, title).draw({{blue}}),
              Renderer(width, height, plain, {0, 0, 255}, title).draw({}));
}

TEST(WordsOnThePicture, MayBeTooManyOrTooWide) {
    const std::vector<Words> many(30, {"as wide as ten pictures and no narrower", white});
    for (const auto& [columns, rows] : {std::pair{64, 48}, {9, 9}, {1, 1}, {300, 7}}) {
        const Image image = Renderer(columns, rows, plain, black, many).draw({});
        EXPECT_EQ(image.width, columns);
        for (int row = 0; row < rows; ++row) EXPECT_EQ(pixel(image, columns - 1, row), black);
    }
}

// Only a part of a picture is drawn anew; it must be the same bytes as a picture drawn whole.
TEST(Pictures, DoNotDependOnThoseBefore) {
    Renderer renderer(width, height, plain, {10, 20, 30}, title);
    std::vector<std::vector<Polyline>> clip;
    for (int frame = 0; frame < 12; ++frame) {
        const double angle = 0.7 * frame;
        const Eigen::Array2d end(30.0 * std::cos(angle), 22.0 * std::sin(angle));
        clip.push_back({line({{0.0, 0.0}, end}, 3.0, 6.0), line({{-5.0, -3.0}, -0.5 * end}, 3.0, 6.0)});
        clip.back()[1].color = {255, 0, 80};
        if (frame % 5 == 4) clip.back().clear();
        if (frame % 5 == 2) clip.back().pop_back();
    }
    for (int repetition = 0; repetition < 2; ++repetition) {
        for (const std::vector<Polyline>& polylines : clip) {
            const Image alone = Renderer(width, height, plain, {10, 20, 30}, title).draw(polylines);
            EXPECT_EQ(renderer.draw(polylines), alone);
        }
    }
}

// Whether two pictures are the same outside of some tiles.
bool same_outside(const Tiles& tiles, const Image& a, const Image& b) {
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            if (!tiles.contains(x / tile_side, y / tile_side) && pixel(a, x, y) != pixel(b, x, y))
                return false;
    return true;
}

// Lines at all angles, across the picture, out of it and along its edges, thin and thick.
TEST(Pictures, DifferFromOthersOnlyInTheTilesThatTheySay) {
    constexpr int side = 300;
    const Color background = {10, 20, 30};
    const Image empty = filled(side, side, background);
    Renderer renderer(side, side, {{0.0, 0.0}, side}, background, title);
    Image before = empty;
    std::size_t columns = 0;
    for (int frame = 0; frame < 300; ++frame) {
        const double angle = 0.37 * frame;
        const Eigen::Array2d begin(150.0 * std::sin(0.11 * frame), 150.0 * std::cos(0.23 * frame));
        const Eigen::Array2d end = begin + (frame % 210) * Eigen::Array2d(std::cos(angle), std::sin(angle));
        const double thick = frame % 7;
        const Image& image = renderer.draw({{line({begin, end}, thick, 3.0 * (frame % 5))}});
        EXPECT_TRUE(same_outside(renderer.inked(), image, empty)) << frame;
        EXPECT_TRUE(same_outside(renderer.changed(), image, before)) << frame;
        before = image;
        for (const PixelBox& box : renderer.changed().runs())
            columns += static_cast<std::size_t>(box.right - box.left);
    }
    EXPECT_LT(columns, 300U * side * 10 / 2);  // in ten rows of tiles: less than half, on average
}

std::string error_of_size(int columns, int rows) {
    try {
        Renderer(columns, rows, plain, black, {});
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

TEST(Pictures, OfImpossibleSizesAreRefusedWithTheLimit) {
    EXPECT_THAT(error_of_size(100000, 7),
                testing::HasSubstr("100000x7 pixels; the OpenGL driver draws 1x1 to "));
    EXPECT_THAT(error_of_size(7, 100000), testing::HasSubstr("7x100000 pixels"));
    EXPECT_THAT(error_of_size(0, 7), testing::HasSubstr("0x7 pixels"));
    EXPECT_THAT(error_of_size(7, -1), testing::HasSubstr("7x-1 pixels"));
}

}  // namespace
}  // namespace ropesim
