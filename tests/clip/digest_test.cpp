#include "clip/digest.h"

#include <gtest/gtest.h>
#include <vector>

namespace ropesim {
namespace {

// xxhsum -H2 says so of an empty file.
TEST(Digest, IsXxh3) {
    EXPECT_EQ(digest(""), "99aa06d3014798d86001c324468d497f");
}

TEST(Digest, IsTheSameOfParts) {
    std::string bytes(5'000'000, '\0');
    for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<char>(i * i >> 3);
    for (const std::size_t part : {std::size_t{1000}, std::size_t{1} << 20, bytes.size()}) {
        Digest parts;
        for (std::size_t begin = 0; begin < bytes.size(); begin += part) {
            const std::string some = bytes.substr(begin, part);
            parts.add({reinterpret_cast<const std::uint8_t*>(some.data()), some.size()});
        }
        EXPECT_EQ(parts.text(), digest(bytes)) << part;
    }
}

}  // namespace
}  // namespace ropesim
