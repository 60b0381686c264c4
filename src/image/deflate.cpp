#include "image/deflate.h"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>

// Section numbers are those of RFC 1951: Deutsch, DEFLATE Compressed Data Format Specification, 1996.

namespace ropesim {

namespace {

constexpr std::size_t end_of_block = 256;       // after the 256 bytes, before the lengths (3.2.5)
constexpr std::size_t length_symbols = 257;     // the first of them
constexpr std::size_t longest_symbol = 285;     // 258 bytes, and no extra bits
constexpr std::uint32_t dynamic_codes = 2;      // the type of a block (3.2.3)
constexpr int longest_code = 15;                // bits (3.2.7)
constexpr int longest_code_of_code_length = 7;  // bits (3.2.7)

// The order in which the lengths of the code of code lengths are written (3.2.7).
constexpr std::array<std::uint8_t, 19> order_of_lengths{16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                        11, 4,  12, 3, 13, 2, 14, 1, 15};

// A number as deflate writes it: a Huffman symbol for a range of numbers, then the place in the range.
struct Ranged {
    std::size_t symbol;
    std::uint32_t extra;
    std::uint32_t extra_bits;
};

// The tables of 3.2.5 as a formula: numbers below 2^(m+1) are ranges of their own; above, each power of
// two is split into 2^m ranges. m is 2 for lengths less 3 and 1 for distances less 1.
constexpr Ranged ranged(std::uint32_t number, std::uint32_t m) {
    if (number < 2U << m) return {number, 0, 0};
    const std::uint32_t extra_bits = static_cast<std::uint32_t>(std::bit_width(number)) - 1 - m;
    const std::uint32_t leading = number >> extra_bits;  // 2^m to 2^(m+1) - 1
    return {leading + (extra_bits << m), number & ((1U << extra_bits) - 1), extra_bits};
}

constexpr Ranged ranged_length(std::uint16_t length) {
    if (length == longest_repetition) return {longest_symbol, 0, 0};
    Ranged result = ranged(length - 3U, 2);
    result.symbol += length_symbols;
    return result;
}

// By length.
constexpr auto ranged_lengths = [] {
    std::array<Ranged, longest_repetition + 1> all{};
    for (std::uint16_t length = shortest_repetition; length <= longest_repetition; ++length)
        all[length] = ranged_length(length);
    return all;
}();

Ranged ranged_distance(std::uint16_t distance) {
    return ranged(distance - 1U, 1);
}

// Depths of the leaves of Huffman's tree for these counts, which ascend; at least two. Each step joins the
// two lightest of what is left; joined nodes come out in ascending order, so that two queues suffice.
std::vector<int> huffman_depths(std::span<const std::uint64_t> counts) {
    const std::size_t leaves = counts.size();
    std::vector<std::uint64_t> weight;
    weight.reserve(2 * leaves - 1);
    weight.assign(counts.begin(), counts.end());
    std::vector<std::size_t> parent(2 * leaves - 1);
    std::size_t leaf = 0;
    std::size_t joined = leaves;
    while (weight.size() < parent.size()) {
        std::uint64_t sum = 0;
        for (int i = 0; i < 2; ++i) {
            const bool take_leaf =
                leaf < leaves && (joined == weight.size() || weight[leaf] <= weight[joined]);
            const std::size_t lightest = take_leaf ? leaf++ : joined++;
            sum += weight[lightest];
            parent[lightest] = weight.size();
        }
        weight.push_back(sum);
    }
    std::vector<int> depth(parent.size(), 0);
    for (std::size_t i = parent.size() - 1; i-- > 0;) depth[i] = depth[parent[i]] + 1;
    depth.resize(leaves);
    return depth;
}

// A Huffman code's length for each symbol, 0 where its count is 0; none is longer than `limit`. Where
// Huffman's tree is deeper, the counts are drawn together by halving until it is not.
std::vector<std::uint8_t> code_lengths(std::span<const std::uint32_t> counts, int limit) {
    constexpr int symbol_bits = 16;
    std::vector<std::uint64_t> counted;  // a count above its symbol, which orders equal counts
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (counts[i] > 0) counted.push_back(std::uint64_t{counts[i]} << symbol_bits | i);
    }
    std::ranges::sort(counted);
    std::vector<std::uint64_t> ascending;
    for (const std::uint64_t each : counted) ascending.push_back(each >> symbol_bits);
    std::vector<int> depths = huffman_depths(ascending);
    while (std::ranges::max(depths) > limit) {
        for (std::uint64_t& count : ascending) count = count / 2 + 1;
        depths = huffman_depths(ascending);
    }
    std::vector<std::uint8_t> lengths(counts.size(), 0);
    for (std::size_t i = 0; i < counted.size(); ++i) {
        lengths[counted[i] & ((1U << symbol_bits) - 1)] = static_cast<std::uint8_t>(depths[i]);
    }
    return lengths;
}

std::uint16_t reversed(std::uint16_t bits, int count) {
    std::uint16_t result = 0;
    for (int i = 0; i < count; ++i) {
        result = static_cast<std::uint16_t>(result << 1 | (bits >> i & 1));
    }
    return result;
}

// The codes that follow from their lengths (3.2.2).
std::vector<Bits> codes(std::span<const std::uint8_t> lengths) {
    std::array<std::uint16_t, longest_code + 1> count{};  // of codes, by length
    for (const std::uint8_t length : lengths) ++count[length];
    count[0] = 0;
    std::array<std::uint16_t, longest_code + 1> next{};  // code, by length
    for (std::size_t i = 1; i < next.size(); ++i) {
        next[i] = static_cast<std::uint16_t>((next[i - 1] + count[i - 1]) << 1);
    }
    std::vector<Bits> result;
    result.reserve(lengths.size());
    for (const std::uint8_t length : lengths) {
        result.push_back({length == 0 ? 0U : reversed(next[length]++, length), length});
    }
    return result;
}

// Huffman's tree needs two leaves.
void use_two_symbols(std::span<std::uint32_t> counts) {
    auto used = std::ranges::count_if(counts, [](std::uint32_t count) { return count > 0; });
    for (std::size_t i = 0; used < 2; ++i) {
        if (counts[i] > 0) continue;
        counts[i] = 1;
        ++used;
    }
}

// One symbol of the alphabet in which a block's code lengths are written (3.2.7).
struct LengthSymbol {
    std::uint8_t symbol;
    std::uint8_t extra;
    std::uint8_t extra_bits;
};

LengthSymbol repeated(std::uint8_t symbol, std::size_t excess, int extra_bits) {
    return {symbol, static_cast<std::uint8_t>(excess), static_cast<std::uint8_t>(extra_bits)};
}

// Code lengths as such symbols: 0 to 15 stand for themselves, 16 for 3 to 6 of what came before,
// 17 for 3 to 10 zeros, 18 for 11 to 138 zeros.
std::vector<LengthSymbol> length_symbols_of(std::span<const std::uint8_t> lengths) {
    std::vector<LengthSymbol> symbols;
    for (std::size_t i = 0; i < lengths.size();) {
        std::size_t end = i;
        while (end < lengths.size() && lengths[end] == lengths[i]) ++end;
        const std::size_t run = end - i;
        if (lengths[i] == 0 && run >= 11) {
            const std::size_t taken = std::min<std::size_t>(run, 138);
            symbols.push_back(repeated(18, taken - 11, 7));
            i += taken;
        } else if (lengths[i] == 0 && run >= 3) {
            symbols.push_back(repeated(17, run - 3, 3));
            i += run;
        } else {
            symbols.push_back({lengths[i], 0, 0});
            ++i;
            if (run < 4 || lengths[i - 1] == 0) continue;
            const std::size_t taken = std::min<std::size_t>(run - 1, 6);
            symbols.push_back(repeated(16, taken - 3, 2));
            i += taken;
        }
    }
    return symbols;
}

std::size_t used_symbols(std::span<const std::uint8_t> lengths) {
    std::size_t used = lengths.size();
    while (used > 0 && lengths[used - 1] == 0) --used;
    return used;
}

Bits joined(Bits first, Bits next) {
    return {first.bits | next.bits << first.count, first.count + next.count};
}

}  // namespace

void TokenCounts::add(Token token, std::uint32_t times) {
    if (token.length == 0) {
        literals[token.byte_or_distance] += times;
    } else {
        literals[ranged_lengths[token.length].symbol] += times;
        distances[ranged_distance(token.byte_or_distance).symbol] += times;
    }
}

void TokenCounts::add(const TokenCounts& others, std::uint32_t times) {
    for (std::size_t i = 0; i < literals.size(); ++i) literals[i] += times * others.literals[i];
    for (std::size_t i = 0; i < distances.size(); ++i) distances[i] += times * others.distances[i];
}

std::vector<std::uint8_t> BitWriter::finish() {
    stream_.resize(size_);
    if (open_.count > 0) stream_.push_back(static_cast<std::uint8_t>(open_.bits));
    return std::move(stream_);
}

// A block with dynamic Huffman codes (3.2.7).
void BlockWriter::begin(TokenCounts counts, bool last) {
    counts.literals[end_of_block] = 1;
    use_two_symbols(counts.literals);
    use_two_symbols(counts.distances);
    const std::vector<std::uint8_t> literals = code_lengths(counts.literals, longest_code);
    const std::vector<std::uint8_t> distances = code_lengths(counts.distances, longest_code);
    writer_.put({last ? 1U : 0U, 1});
    writer_.put({dynamic_codes, 2});
    write_code_lengths(literals, distances);

    const std::vector<Bits> codes_of_literals = codes(literals);
    std::copy_n(codes_of_literals.begin(), bytes_.size(), bytes_.begin());
    for (std::size_t length = shortest_repetition; length < lengths_.size(); ++length) {
        const auto& [symbol, extra, extra_bits] = ranged_lengths[length];
        lengths_[length] = joined(codes_of_literals[symbol], {extra, extra_bits});
    }
    std::ranges::copy(codes(distances), distances_.begin());
}

Bits BlockWriter::bits_of(Token token) const {
    if (token.length == 0) return bytes_[token.byte_or_distance];
    const auto [symbol, extra, extra_bits] = ranged_distance(token.byte_or_distance);
    return joined(lengths_[token.length], joined(distances_[symbol], {extra, extra_bits}));
}

void BlockWriter::add(std::span<const Token> tokens) {
    writer_.put_all(tokens, [this](Token token) { return bits_of(token); });
}

std::vector<Bits> BlockWriter::bits_of(std::span<const Token> tokens) const {
    std::vector<Bits> all(1);
    for (const Token& token : tokens) {
        const Bits next = bits_of(token);
        if (all.back().count + next.count > 56) all.push_back({});
        all.back() = joined(all.back(), next);
    }
    return all;
}

void BlockWriter::add(std::span<const Bits> bits) {
    writer_.put_all(bits, [](const Bits& same) { return same; });
}

void BlockWriter::add(std::span<const std::uint16_t> indices, std::span<const Bits> bits) {
    writer_.put_all(indices, [bits](std::uint16_t index) { return bits[index]; });
}

void BlockWriter::end() {
    writer_.put(bytes_[end_of_block]);
}

void BlockWriter::write_code_lengths(std::span<const std::uint8_t> literals,
                                     std::span<const std::uint8_t> distances) {
    const std::size_t literals_used = used_symbols(literals);
    const std::size_t distances_used = used_symbols(distances);
    const auto used_distances = distances.first(distances_used);
    std::vector<std::uint8_t> lengths(literals.begin(), literals.end());
    lengths.resize(literals_used);
    lengths.insert(lengths.end(), used_distances.begin(), used_distances.end());
    const std::vector<LengthSymbol> symbols = length_symbols_of(lengths);

    std::array<std::uint32_t, order_of_lengths.size()> counts{};
    for (const LengthSymbol& symbol : symbols) ++counts[symbol.symbol];
    const std::vector<std::uint8_t> code_sizes = code_lengths(counts, longest_code_of_code_length);
    std::array<std::uint8_t, order_of_lengths.size()> ordered{};
    for (std::size_t i = 0; i < ordered.size(); ++i) ordered[i] = code_sizes[order_of_lengths[i]];
    const std::size_t ordered_used = used_symbols(ordered);

    writer_.put({static_cast<std::uint32_t>(literals_used - 257), 5});
    writer_.put({static_cast<std::uint32_t>(distances_used - 1), 5});
    writer_.put({static_cast<std::uint32_t>(ordered_used - 4), 4});
    for (std::size_t i = 0; i < ordered_used; ++i) writer_.put({ordered[i], 3});
    const std::vector<Bits> code = codes(code_sizes);
    for (const LengthSymbol& symbol : symbols)
        writer_.put(joined(code[symbol.symbol], {symbol.extra, symbol.extra_bits}));
}

void Deflater::write_block(bool last) {
    TokenCounts counts;
    for (const Token& token : tokens_) counts.add(token, 1);
    writer_.begin(counts, last);
    writer_.add(tokens_);
    writer_.end();
    tokens_.clear();
}

}  // namespace ropesim
