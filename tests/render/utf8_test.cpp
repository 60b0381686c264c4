#include "render/utf8.h"

#include <gtest/gtest.h>

#include <string>

namespace ropesim {
namespace {

TEST(DecodeUtf8, ReadsCharactersOfOneToFourBytes) {
    EXPECT_EQ(decode_utf8("a\xC3\xB6\xE2\x80\xA6\xF0\x9F\x98\x80z"), U"a\u00F6\u2026\U0001F600z");
    EXPECT_EQ(decode_utf8(""), U"");
}

// The examples of The Unicode Standard, 15.0, tables 3-8 to 3-11.
TEST(DecodeUtf8, ReplacesEachLongestStartOnce) {
    const std::u32string bad8(8, U'\uFFFD');
    EXPECT_EQ(decode_utf8("\xC0\xAF\xE0\x80\xBF\xF0\x81\x82\x41"), bad8 + U"A");
    EXPECT_EQ(decode_utf8("\xED\xA0\x80\xED\xBF\xBF\xED\xAF\x41"), bad8 + U"A");
    EXPECT_EQ(decode_utf8("\xF4\x91\x92\x93\xFF\x41\x80\xBF\x42"),
              U"\uFFFD\uFFFD\uFFFD\uFFFD\uFFFDA\uFFFD\uFFFDB");
    EXPECT_EQ(decode_utf8("\xE1\x80\xE2\xF0\x91\x92\xF1\xBF\x41"), U"\uFFFD\uFFFD\uFFFD\uFFFDA");
}

TEST(DecodeUtf8, ReplacesACharacterThatIsCutOff) {
    EXPECT_EQ(decode_utf8("a\xE2\x80"), U"a\uFFFD");
}

}  // namespace
}  // namespace ropesim
