#include "render/lettering.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ropesim {
namespace {

constexpr int size = 18;
constexpr int wide = 2000;

Lettering set(std::string_view text, int widest = wide) {
    return set_lines({text}, size, widest).front();
}

bool same(const Lettering& a, const Lettering& b) {
    return a.width == b.width && a.height == b.height && a.coverage == b.coverage;
}

int darkest(const Lettering& line) {
    return line.coverage.empty() ? 0 : *std::max_element(line.coverage.begin(), line.coverage.end());
}

// The coverage in columns left to right - 1.
std::vector<std::uint8_t> columns(const Lettering& line, int left, int right) {
    std::vector<std::uint8_t> kept;
    for (int row = 0; row < line.height; ++row) {
        const auto begin = line.coverage.begin() + row * line.width;
        kept.insert(kept.end(), begin + left, begin + right);
    }
    return kept;
}

// DejaVu Sans: advances of 1303 (m: 1995, i: 569) and a stem through the whole letter, in 2048ths of the em.
TEST(Lettering, HasTheFontsMeasures) {
    EXPECT_NEAR(set("n").width, 1298.0 / 2048.0 * size, 1.0);
    EXPECT_NEAR(set("iiiiiiiiiiiiiiiiiiii").width, 20.0 * 569.0 / 2048.0 * size, 1.0);
    EXPECT_NEAR(set("mmmmmmmmmm").width, 10.0 * 1995.0 / 2048.0 * size, 1.0);
    EXPECT_EQ(darkest(set("l")), 255);
    EXPECT_EQ(darkest(set(" ")), 0);
    EXPECT_EQ(set("").width, 0);
}

TEST(Lettering, KeepsLettersAtWholePixels) {
    const Lettering twice = set("ll");
    const int period = static_cast<int>(569.0 / 2048.0 * size + 0.5);
    EXPECT_EQ(columns(twice, 0, period), columns(twice, period, 2 * period));
}

TEST(Lettering, CutsALineThatIsTooWideWithAnEllipsis) {
    const Lettering whole = set("Steps per frame: 64");
    EXPECT_TRUE(same(set("Steps per frame: 64", whole.width), whole));
    for (int widest = 25; widest < whole.width; ++widest) {
        const Lettering cut = set("Steps per frame: 64", widest);
        ASSERT_LE(cut.width, widest);
        bool found = false;
        for (const std::string_view kept :
             {"", "S", "St", "Ste", "Step", "Steps", "Steps p", "Steps pe", "Steps per", "Steps per f",
              "Steps per fr", "Steps per fra", "Steps per fram", "Steps per frame",
              "Steps per frame:", "Steps per frame: 6"}) {
            found = found || same(cut, set(std::string(kept) + "\xE2\x80\xA6"));
        }
        ASSERT_TRUE(found) << widest;
    }
    EXPECT_TRUE(same(set("abcdefghij", 40), set("abcdefghijklmnop", 40)));
    for (int widest = -3; widest < 25; ++widest) EXPECT_LE(set("word", widest).width, std::max(widest, 0));
}

TEST(Lettering, ShowsBytesThatAreNoText) {
    EXPECT_TRUE(same(set("a\xFFz"), set("a\xEF\xBF\xBDz")));
    EXPECT_GT(darkest(set("\xFF")), 100);
}

// Two characters that the font lacks look alike: as the box of missing letters.
TEST(Lettering, ShowsABoxForAMissingLetter) {
    const Lettering box = set("\xE4\xB8\xAD");
    EXPECT_TRUE(same(box, set("\xE6\x96\x87")));
    EXPECT_GT(darkest(box), 100);
    EXPECT_FALSE(same(box, set("a")));
}

TEST(Lettering, ShowsAccentsAndGreek) {
    EXPECT_FALSE(same(set("o"), set("\xC3\xB6")));
    EXPECT_FALSE(same(set("\xCF\x89"), set("\xE4\xB8\xAD")));
    EXPECT_EQ(set("\xC3\x84").height, set("p").height);
}

}  // namespace
}  // namespace ropesim
