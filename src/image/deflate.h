#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
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

// How often tokens use each symbol of deflate: what its Huffman codes follow from.
struct TokenCounts {
    std::array<std::uint32_t, 286> literals{};  // 256 bytes, the end of a block, lengths
    std::array<std::uint32_t, 30> distances{};

    void add(Token token, std::uint32_t times);
    void add(const TokenCounts& others, std::uint32_t times);
};

// Some bits of a deflate stream, the first lowest.
struct Bits {
    std::uint64_t bits = 0;
    std::uint32_t count = 0;  // at most 56
};

// Appends bits to bytes.
class BitWriter {
  public:
    explicit BitWriter(std::vector<std::uint8_t> stream)
        : stream_(std::move(stream)), size_(stream_.size()) {}

    void put(Bits bits) {
        const Bits one[] = {bits};
        put_all(one, [](const Bits& same) { return same; });
    }

    // What `bits_of` makes of each item.
    template <class Items, class BitsOf>
    void put_all(const Items& items, const BitsOf& bits_of) {
        stream_.resize(size_ + 8 * (std::size(items) + 1));
        std::uint8_t* out = stream_.data() + size_;
        Bits open = open_;
        for (const auto& item : items) {
            const Bits next = bits_of(item);
            open.bits |= next.bits << open.count;
            open.count += next.count;
            for (std::size_t i = 0; i < 8; ++i) out[i] = static_cast<std::uint8_t>(open.bits >> 8 * i);
            out += open.count / 8;
            open.bits >>= open.count / 8 * 8;
            open.count %= 8;
        }
        open_ = open;
        size_ = static_cast<std::size_t>(out - stream_.data());
    }

    // All bytes. Nothing may be put afterwards.
    std::vector<std::uint8_t> finish();

  private:
    std::vector<std::uint8_t> stream_;
    std::size_t size_;  // of what is written; behind it may stand anything
    Bits open_;         // fewer than 8, not written yet
};

// Writes a deflate stream block by block, each with Huffman codes of its own. The same tokens give the same
// bytes everywhere: all is integer arithmetic in a fixed order.
class BlockWriter {
  public:
    // Appends to what `stream` has already.
    explicit BlockWriter(std::vector<std::uint8_t> stream) : writer_(std::move(stream)) {}

    // Begins a block of tokens that have these counts.
    void begin(TokenCounts counts, bool last);
    void add(std::span<const Token> tokens);
    // Tokens as bits of this block, for those that come many times.
    Bits bits_of(Token token) const;
    std::vector<Bits> bits_of(std::span<const Token> tokens) const;
    void add(std::span<const Bits> bits);
    // The bits that stand in `bits` at each of the indices.
    void add(std::span<const std::uint16_t> indices, std::span<const Bits> bits);
    void end();

    // The whole stream. Nothing may be added afterwards.
    std::vector<std::uint8_t> finish() { return writer_.finish(); }

  private:
    void write_code_lengths(std::span<const std::uint8_t> literals, std::span<const std::uint8_t> distances);

    BitWriter writer_;

    // The codes of the block.
    std::array<Bits, 257> bytes_;  // and the end of the block
    std::array<Bits, longest_repetition + 1> lengths_;
    std::array<Bits, 30> distances_;
};

// A deflate stream of tokens as they come, in blocks of at most `block_tokens` of them.
class Deflater {
  public:
    static constexpr std::size_t block_tokens = 65536;

    // Appends to what `stream` has already.
    explicit Deflater(std::vector<std::uint8_t> stream) : writer_(std::move(stream)) {}

    void add(Token token) {
        if (tokens_.size() == block_tokens) write_block(false);
        tokens_.push_back(token);
    }

    // The whole stream. Nothing may be added afterwards.
    std::vector<std::uint8_t> finish() {
        write_block(true);
        return writer_.finish();
    }

  private:
    void write_block(bool last);

    BlockWriter writer_;
    std::vector<Token> tokens_;  // of the block that is not written yet
};

}  // namespace ropesim
