#include "image/row_tokens.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace ropesim {

namespace {

constexpr std::uint16_t pixel_bytes = 3;
constexpr std::size_t worth_skipping = 64;  // zeros that are faster summed up at once than one by one
constexpr std::size_t readable = 4;         // bytes behind a row, of which `repeats` may read some
constexpr std::uint8_t filter_up = 2;       // what a row of a PNG begins with that is less the row above

constexpr RowToken first_of_byte = 256;  // the shortest repetition of a byte
constexpr RowToken first_of_pixel = first_of_byte + repetition_lengths;

// Writes repetitions, of those whose shortest is the token `first`, for as much of `length` bytes as they can
// be used for: all, or all but one or two. Returns how many.
std::size_t add_run(std::size_t length, RowToken first, RowToken*& out) {
    std::size_t left = length;
    while (left >= shortest_repetition) {
        const std::size_t part = std::min<std::size_t>(left, longest_repetition);
        *out++ = static_cast<RowToken>(first + part - shortest_repetition);
        left -= part;
    }
    return length - left;
}

// Whether the three bytes from `i` on are those that stand `distance` bytes before them. One more may be
// read.
bool repeats(const std::uint8_t* i, std::ptrdiff_t distance) {
    constexpr std::uint32_t three = std::endian::native == std::endian::little ? 0x00ffffff : 0xffffff00;
    std::uint32_t here = 0;
    std::uint32_t before = 0;
    std::memcpy(&here, i, sizeof here);
    std::memcpy(&before, i - distance, sizeof before);
    return ((here ^ before) & three) == 0;
}

// How many bytes from `begin` on repeat what stands `distance` bytes before them, up to `end`.
std::size_t run_length(const std::uint8_t* begin, std::ptrdiff_t distance, const std::uint8_t* end) {
    const std::uint8_t* i = begin;
    while (i < end && *i == *(i - distance)) ++i;
    return static_cast<std::size_t>(i - begin);
}

// The first byte of begin to end that is not zero, or the end.
const std::uint8_t* past_zeros(const std::uint8_t* begin, const std::uint8_t* end) {
    constexpr std::array<std::uint8_t, 32> zeros{};
    const std::uint8_t* i = begin;
    while (end - i >= 32 && std::memcmp(i, zeros.data(), 32) == 0) i += 32;
    return std::find_if(i, end, [](std::uint8_t byte) { return byte != 0; });
}

}  // namespace

Token token_of(RowToken token) {
    if (token < first_of_byte) return {0, token};
    const bool of_byte = token < first_of_pixel;
    const int longer = token - (of_byte ? first_of_byte : first_of_pixel);
    return {static_cast<std::uint16_t>(shortest_repetition + longer),
            of_byte ? std::uint16_t{1} : pixel_bytes};
}

RowTokenizer::RowTokenizer(int width)
    : zeros_(pixel_bytes * static_cast<std::size_t>(width), 0),
      filtered_(1 + zeros_.size() + readable, 0),
      tokens_(1 + zeros_.size()) {
    filtered_[0] = filter_up;
}

std::vector<Token> RowTokenizer::repeated_row() const {
    std::vector<RowToken> tokens(1 + zeros_.size(), 0);
    RowToken* out = tokens.data();
    *out++ = filter_up;
    *out++ = 0;
    const std::size_t zeros = zeros_.size() - 1;
    const std::size_t literals = zeros - add_run(zeros, first_of_byte, out);
    tokens.resize(static_cast<std::size_t>(out - tokens.data()) + literals);
    std::vector<Token> row;
    for (const RowToken token : tokens) row.push_back(token_of(token));
    return row;
}

void RowTokenizer::tokenize(const Image& image, const Tiles& inked, int row_of_tiles, RowTokens& rows) {
    rows.tokens.clear();
    rows.ends.clear();
    rows.repeated_rows = 0;
    rows.counts = {};
    rows.checksum = {};
    const std::size_t stride = zeros_.size();
    const int top = row_of_tiles * tile_side;
    const int bottom = std::min(top + tile_side, image.height);
    for (int y = top; y < bottom; ++y) {
        const std::uint8_t* row = image.rgb.data() + static_cast<std::size_t>(y) * stride;
        if (y == 0) spans_ = {{0, stride}};
        if (y == top && y > 0) find_spans(inked, row_of_tiles - 1, row_of_tiles);
        if (y == top + 1) find_spans(inked, row_of_tiles, row_of_tiles);
        add_row(row, y == 0 ? zeros_.data() : row - stride, rows);
    }
}

void RowTokenizer::find_spans(const Tiles& inked, int first_row, int last_row) {
    boxes_.clear();
    inked.append_runs(first_row, last_row, boxes_);
    spans_.clear();
    for (const PixelBox& box : boxes_)
        spans_.push_back({pixel_bytes * static_cast<std::size_t>(box.left),
                          pixel_bytes * static_cast<std::size_t>(box.right)});
}

void RowTokenizer::add_row(const std::uint8_t* row, const std::uint8_t* above, RowTokens& rows) {
    const auto equal = [&](const Span& span) {
        return std::memcmp(row + span.begin, above + span.begin, span.end - span.begin) == 0;
    };
    if (std::ranges::all_of(spans_, equal)) {
        rows.checksum.add({&filter_up, 1});
        rows.checksum.add_zeros(zeros_.size());
        ++rows.repeated_rows;
    } else {
        std::uint8_t* const filtered = &filtered_[1];
        for (const auto [begin, end] : spans_)  // copies, lest each byte written might change them
            for (std::size_t i = begin; i < end; ++i)
                filtered[i] = static_cast<std::uint8_t>(row[i] - above[i]);
        add_filtered_row(rows);
        for (const auto& [begin, end] : spans_) std::memset(filtered + begin, 0, end - begin);
    }
    rows.ends.push_back(rows.tokens.size());
}

void RowTokenizer::add_filtered_row(RowTokens& rows) {
    const std::uint8_t* const bytes = filtered_.data();
    const std::size_t size = 1 + zeros_.size();
    RowToken* out = tokens_.data();
    std::size_t unchecked = 0;
    span_ = 0;
    *out++ = bytes[0];
    for (std::size_t i = 1; i < size;) {
        const bool repeats_byte = repeats(bytes + i, 1);
        const bool repeats_pixel = !repeats_byte && i >= pixel_bytes && repeats(bytes + i, pixel_bytes);
        if ((!repeats_byte && !repeats_pixel) || size - i < shortest_repetition) {
            *out++ = bytes[i++];
            continue;
        }
        const bool zeros = repeats_byte && bytes[i] == 0;
        const std::size_t found =
            zeros ? zeros_from(i) : run_length(bytes + i, repeats_byte ? 1 : pixel_bytes, bytes + size);
        const std::size_t length = add_run(found, repeats_byte ? first_of_byte : first_of_pixel, out);
        if (zeros && length >= worth_skipping) {
            rows.checksum.add(std::span(bytes + unchecked, bytes + i));
            rows.checksum.add_zeros(length);
            unchecked = i + length;
        }
        i += length;
    }
    rows.checksum.add(std::span(bytes + unchecked, bytes + size));
    rows.tokens.insert(rows.tokens.end(), tokens_.data(), out);
    for (const RowToken token : std::span(tokens_.data(), out)) ++rows.counts[token];
}

// How many bytes of the filtered row are zero from byte i on. Between the spans all are.
std::size_t RowTokenizer::zeros_from(std::size_t i) {
    const std::uint8_t* const filtered = &filtered_[1];
    std::size_t place = i - 1;  // in the row of the picture
    while (span_ < spans_.size()) {
        const auto [begin, end] = spans_[span_];
        place = std::max(place, begin);
        if (place < end) {
            place = static_cast<std::size_t>(past_zeros(filtered + place, filtered + end) - filtered);
            if (place < end) return place - (i - 1);
        }
        ++span_;
    }
    return 1 + zeros_.size() - i;
}

}  // namespace ropesim
