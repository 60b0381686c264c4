#include "scene/words.h"

#include <gtest/gtest.h>

namespace ropesim {
namespace {

const std::vector<std::string_view> keys{"mass", "masses", "stiffness", "nodes", "color", "end"};

TEST(Suggestion, FindsAWordOneSlipAway) {
    EXPECT_EQ(suggestion("stifness", keys), "stiffness");  // a letter lost
    EXPECT_EQ(suggestion("colour", keys), "color");        // one too many
    EXPECT_EQ(suggestion("nodas", keys), "nodes");         // another
    EXPECT_EQ(suggestion("noeds", keys), "nodes");         // two swapped count as one slip
}

TEST(Suggestion, TakesTheNearest) {
    EXPECT_EQ(suggestion("massess", keys), "masses");
    EXPECT_EQ(suggestion("mas", keys), "mass");
    EXPECT_EQ(suggestion("mass", keys), "mass");
}

TEST(Suggestion, IsSilentWhereNothingIsNear) {
    EXPECT_EQ(suggestion("gravity", keys), "");
    EXPECT_EQ(suggestion("", keys), "");
    EXPECT_EQ(suggestion("x", keys), "");
    EXPECT_EQ(suggestion("mass", {}), "");
    EXPECT_EQ(suggestion(std::string(1'000'000, 'm'), keys), "");
}

TEST(Printable, EscapesWhatWouldBreakALine) {
    EXPECT_EQ(printable("a\nb\tc\x1b[0m\x7f"), "a\\nb\\x09c\\x1b[0m\\x7f");
    EXPECT_EQ(printable("St\u00f6rmer \u2013 Verlet"), "St\u00f6rmer \u2013 Verlet");
}

TEST(Printable, EscapesBytesThatAreNotUtf8AndTheUpperControls) {
    EXPECT_EQ(printable("\xff"), "\\xff");
    EXPECT_EQ(printable("a\xc3"), "a\\xc3");                  // cut short
    EXPECT_EQ(printable("\xc0\x80"), "\\xc0\\x80");           // longer than need be
    EXPECT_EQ(printable("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // a surrogate
    EXPECT_EQ(printable("\xc2\x85"), "\\xc2\\x85");           // U+0085, next line
}

TEST(OneLine, IsWholeAndEscapesWhatWouldBreakIt) {
    EXPECT_EQ(one_line("a\nb\x1b[2J\x7f"), "a\\nb\\x1b[2J\\x7f");
    EXPECT_EQ(one_line("Störmer \xc2\x9b"), "Störmer \\xc2\\x9b") << "a control character of two bytes";
    EXPECT_EQ(one_line(std::string(1000, 'x')), std::string(1000, 'x'));
}

TEST(InGnuplotQuotes, IsWhateverItIsToTheLetter) {
    EXPECT_EQ(in_gnuplot_quotes("a`b`\\\"$c"), "'a`b`\\\"$c'");
    EXPECT_EQ(in_gnuplot_quotes("'.system('true').'"), "'''.system(''true'').'''");
}

TEST(Printable, CutsBetweenCharacters) {
    std::string umlauts;
    for (int i = 0; i < 40; ++i) umlauts += "\u00e4";
    const std::string shown = printable("x" + umlauts);
    EXPECT_TRUE(shown.ends_with("\u00e4..."));
    EXPECT_EQ(shown.find('\\'), std::string::npos);
    EXPECT_EQ(printable(std::string(60, 'x')), std::string(60, 'x'));
    EXPECT_EQ(printable(std::string(61, 'x')), std::string(60, 'x') + "...");
}

}  // namespace
}  // namespace ropesim
