#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace ropesim {

// What deflate makes of bytes (RFC 1951): a byte as it is, or a repetition of `length` bytes that stand
// `distance` bytes further back.
struct Token {
    std::uint16_t length = 0;            // 3 to 258; 0 for a byte as it is
    std::uint16_t byte_or_distance = 0;  // a distance is 1 to 32768
};

inline constexpr std::uint16_t shortest_repetition = 3;
inline constexpr std::uint16_t longest_repetition = 258;
inline constexpr std::uint16_t farthest_repetition = 32768;

// Writes tokens as a deflate stream: blocks of at most `block_tokens` of them, each with Huffman codes of
// its own. The same tokens give the same bytes everywhere: all is integer arithmetic in a fixed order.
class Deflater {
  public:
    static constexpr std::size_t block_tokens = 65536;

    // Appends to what `stream` has already.
    explicit Deflater(std::vector<std::uint8_t> stream);

    void add(Token token) {
        if (tokens_.size() == block_tokens) write_block(false);
        tokens_.push_back(token);
    }

    // The whole stream. Nothing may be added afterwards.
    std::vector<std::uint8_t> finish();

  private:
    void write_block(bool last);
    void write_tokens(std::span<const std::uint8_t> literals, std::span<const std::uint8_t> distances);
    void write_code_lengths(std::span<const std::uint8_t> literals, std::span<const std::uint8_t> distances);
    void write_word();

    // At most 16 bits.
    void put(std::uint32_t bits, int count) {
        bits_ |= std::uint64_t{bits} << bit_count_;
        bit_count_ += count;
        if (bit_count_ >= 32) write_word();
    }

    std::vector<std::uint8_t> stream_;
    std::vector<Token> tokens_;  // of the block that is not written yet
    std::uint64_t bits_ = 0;     // not written yet, the earliest lowest
    int bit_count_ = 0;
};

}  // namespace ropesim
