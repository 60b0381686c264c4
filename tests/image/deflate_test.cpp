#include "image/deflate.h"

#include "image/unpacked.h"

#include <gtest/gtest.h>
#include <zlib.h>
#include <random>

namespace ropesim {
namespace {

using Bytes = std::vector<std::uint8_t>;

// What the tokens mean, by their definition.
Bytes meaning(std::span<const Token> tokens) {
    Bytes bytes;
    for (const Token& token : tokens) {
        if (token.length == 0) bytes.push_back(static_cast<std::uint8_t>(token.byte_or_distance));
        for (int i = 0; i < token.length; ++i) bytes.push_back(bytes[bytes.size() - token.byte_or_distance]);
    }
    return bytes;
}

Bytes deflated(std::span<const Token> tokens) {
    Deflater deflater({});
    for (const Token& token : tokens) deflater.add(token);
    return deflater.finish();
}

void expect_unpacks(const std::vector<Token>& tokens) {
    const Bytes expected = meaning(tokens);
    EXPECT_EQ(unpacked(deflated(tokens), expected.size()), expected);
}

TEST(Deflate, OfNothingIsAWholeStream) {
    const Bytes stream = deflated({});
    Bytes byte(1);
    z_stream state{};
    inflateInit2(&state, -15);
    state.next_in = const_cast<Bytef*>(stream.data());
    state.avail_in = static_cast<uInt>(stream.size());
    state.next_out = byte.data();
    state.avail_out = 1;
    EXPECT_EQ(inflate(&state, Z_FINISH), Z_STREAM_END);
    EXPECT_EQ(state.total_out, 0U);
    inflateEnd(&state);
}

TEST(Deflate, WritesOneByteAlone) {
    expect_unpacks({{0, 77}});
}

TEST(Deflate, WritesEveryLength) {
    std::vector<Token> tokens{{0, 1}, {0, 2}, {0, 3}};
    for (std::uint16_t length = shortest_repetition; length <= longest_repetition; ++length) {
        tokens.push_back({length, 3});
        tokens.push_back({0, static_cast<std::uint16_t>(length % 256)});
    }
    expect_unpacks(tokens);
}

TEST(Deflate, WritesEveryDistance) {
    std::vector<Token> tokens;
    for (std::uint32_t i = 0; i < farthest_repetition; ++i) {
        tokens.push_back({0, static_cast<std::uint16_t>(i * 2654435769U >> 24)});
    }
    for (std::uint32_t distance = 1; distance <= farthest_repetition; ++distance) {
        tokens.push_back({3, static_cast<std::uint16_t>(distance)});
    }
    expect_unpacks(tokens);
}

TEST(Deflate, WritesBlocksOfAllSizes) {
    for (const std::size_t extra : {0U, 1U, 70000U}) {
        std::mt19937 random(1);
        std::vector<Token> tokens{{0, 0}};
        while (tokens.size() < Deflater::block_tokens + extra) {
            tokens.push_back({0, static_cast<std::uint16_t>(random() >> 24)});
        }
        expect_unpacks(tokens);
    }
}

// Counts like Fibonacci's numbers make Huffman's tree as deep as it has leaves: far beyond 15 bits.
TEST(Deflate, KeepsCodesWithinFifteenBits) {
    std::vector<Token> tokens;
    std::size_t count = 1;
    std::size_t next = 1;
    for (std::uint16_t byte = 0; byte < 22; ++byte) {
        tokens.insert(tokens.end(), count, Token{0, byte});
        std::swap(count, next);
        next += count;
    }
    ASSERT_LT(tokens.size(), Deflater::block_tokens);
    expect_unpacks(tokens);
}

TEST(Deflate, IsAsShortAsEntropyAllows) {
    std::vector<Token> tokens;
    for (std::uint16_t i = 0; i < 40000; ++i) tokens.push_back({0, static_cast<std::uint16_t>(i % 16)});
    // Sixteen bytes equally often: 4 bits each but for the end of the block, which lengthens one by a bit.
    EXPECT_LT(deflated(tokens).size(), 40000 * 4.1 / 8 + 100);
}

TEST(Deflate, UnpacksWhateverTheTokens) {
    std::mt19937 random(7);
    for (int round = 0; round < 200; ++round) {
        std::vector<Token> tokens{{0, 9}};
        std::size_t size = 1;
        const std::size_t bytes = 1 + random() % 256;
        for (std::size_t i = random() % 2000; i > 0; --i) {
            Token token{0, static_cast<std::uint16_t>(random() % bytes)};
            if (random() % 3 == 0) {
                const std::size_t farthest = std::min<std::size_t>(size, farthest_repetition);
                token = {static_cast<std::uint16_t>(3 + random() % 256),
                         static_cast<std::uint16_t>(1 + random() % farthest)};
            }
            size += std::max<std::size_t>(token.length, 1);
            tokens.push_back(token);
        }
        expect_unpacks(tokens);
    }
}

}  // namespace
}  // namespace ropesim
