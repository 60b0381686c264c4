#include "scene/key_length.h"

#include <gtest/gtest.h>

#include <string>

namespace ropesim {
namespace {

std::string parts(std::size_t count, const std::string& part = "a", const std::string& dot = ".") {
    std::string key = part;
    for (std::size_t i = 1; i < count; ++i) key += dot + part;
    return key;
}

// "line:column" of what is refused, or "".
std::string found(const std::string& toml) {
    const auto place = overlong_key(toml);
    return place ? std::to_string(place->line) + ":" + std::to_string(place->column) : "";
}

TEST(KeyLength, IsRefusedFromAHundredDotsOn) {
    EXPECT_EQ(found(parts(most_key_parts) + " = 1"), "");
    EXPECT_EQ(found(parts(most_key_parts + 1) + " = 1"), "1:200");
    EXPECT_EQ(found("\n\n[[" + parts(1'000'000) + "]]"), "3:202");
    EXPECT_EQ(found("x = { " + parts(101) + " = 1 }"), "1:206");
}

TEST(KeyLength, CountsWhateverKeysAreWrittenAs) {
    EXPECT_NE(found(parts(101, "\"=, \\\" [\"")), "");
    EXPECT_NE(found(parts(101, "'=,\\'")), "");
    EXPECT_NE(found(parts(101, "a-1_", " \t. ")), "");
}

TEST(KeyLength, IsNotMistakenForNumbersTextsAndComments) {
    std::string numbers = "1.5";
    for (int i = 0; i < 1000; ++i) numbers += i % 2 == 0 ? ",2.5" : "\n,2.5";
    const std::string dots(1000, '.');
    EXPECT_EQ(found("masses = [" + numbers + "]"), "");
    EXPECT_EQ(found("title = \"\\\"" + dots + "\""), "");
    EXPECT_EQ(found("title = '" + dots + "'"), "");
    EXPECT_EQ(found("title = \"\"\"\n\"" + dots + "\n\"\"\""), "");
    EXPECT_EQ(found("title = '''\n'" + dots + "\n'''"), "");
    EXPECT_EQ(found("# " + dots + "\n# \"\n# '\na.b = 1"), "");
    EXPECT_EQ(found("a = \"" + dots), "") << "a text that does not end";
    EXPECT_EQ(found(""), "");
}

}  // namespace
}  // namespace ropesim
