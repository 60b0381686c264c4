#include "image/zlib_stream.h"

#include "image/deflate.h"

#include <zlib.h>
#include <algorithm>
#include <cstring>

namespace ropesim {

namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::uint16_t pixel_bytes = 3;
constexpr std::size_t worth_skipping = 64;  // zeros that are faster summed up at once than one by one
constexpr std::uint8_t filter_up = 2;       // what a row of a PNG begins with that is less the row above

// The checksum of RFC 1950, section 8.2: a = 1 + sum of the bytes, b = sum of all values of a, modulo 65521.
class Adler32 {
  public:
    void add(Bytes bytes) {
        value_ = static_cast<std::uint32_t>(adler32_z(value_, bytes.data(), bytes.size()));
    }

    // A zero leaves a as it is, so that n of them add n a to b.
    void add_zeros(std::size_t count) {
        const std::uint64_t a = value_ & 0xffffU;
        const std::uint64_t b = value_ >> 16;
        value_ = static_cast<std::uint32_t>((b + count % 65521 * a) % 65521 << 16 | a);
    }

    std::uint32_t value() const { return value_; }

  private:
    std::uint32_t value_ = 1;
};

// The two bytes a zlib stream begins with (RFC 1950, section 2.2): deflate, a window of 32 KB, no
// dictionary, fastest level; a multiple of 31.
std::vector<std::uint8_t> zlib_header() {
    return {0x78, 0x01};
}

std::vector<std::uint8_t> finished(Deflater& deflater, const Adler32& checksum) {
    std::vector<std::uint8_t> stream = deflater.finish();
    for (int shift = 24; shift >= 0; shift -= 8) {
        stream.push_back(static_cast<std::uint8_t>(checksum.value() >> shift));
    }
    return stream;
}

void add_byte(Deflater& deflater, std::uint8_t byte) {
    deflater.add({0, byte});
}

// Repetitions of what stands `distance` bytes back, for as much of `length` bytes as they can be used for:
// all, or all but one or two. Returns how many.
std::size_t add_run(Deflater& deflater, std::size_t length, std::uint16_t distance) {
    std::size_t left = length;
    while (left >= shortest_repetition) {
        const auto part = static_cast<std::uint16_t>(std::min<std::size_t>(left, longest_repetition));
        deflater.add({part, distance});
        left -= part;
    }
    return length - left;
}

// From `i` on, past blocks that are equal to what stands `distance` bytes before them.
template <std::ptrdiff_t block>
const std::uint8_t* past_equal(const std::uint8_t* i, std::ptrdiff_t distance, const std::uint8_t* end) {
    while (end - i >= block && std::memcmp(i, i - distance, block) == 0) i += block;
    return i;
}

// How many bytes from `begin` on repeat what stands `distance` bytes before them, up to `end`. Long runs
// are compared in blocks that memcmp is fast at; a call of it for each short one would cost more.
std::size_t run_length(const std::uint8_t* begin, std::ptrdiff_t distance, const std::uint8_t* end) {
    const std::uint8_t* i = past_equal<8>(begin, distance, end - begin < 16 ? end : begin + 16);
    if (i - begin == 16) i = past_equal<8>(past_equal<128>(i, distance, end), distance, end);
    return static_cast<std::size_t>(past_equal<1>(i, distance, end) - begin);
}

// Rows into tokens, filtered Up, one after the other.
class RowCompressor {
  public:
    explicit RowCompressor(std::size_t stride) : filtered_(1 + stride, 0) { filtered_[0] = filter_up; }

    void add_row(const std::uint8_t* row, const std::uint8_t* above) {
        const std::size_t stride = filtered_.size() - 1;
        if (std::memcmp(row, above, stride) == 0) {
            add_repeated_row();
            return;
        }
        std::uint8_t* const filtered = &filtered_[1];
        for (std::size_t i = 0; i < stride; ++i) filtered[i] = static_cast<std::uint8_t>(row[i] - above[i]);
        add_filtered_row();
    }

    std::vector<std::uint8_t> finish() { return finished(deflater_, checksum_); }

  private:
    void add_repeated_row() {
        const std::size_t stride = filtered_.size() - 1;
        add_byte(deflater_, filter_up);
        add_byte(deflater_, 0);
        for (std::size_t i = 1 + add_run(deflater_, stride - 1, 1); i < stride; ++i) add_byte(deflater_, 0);
        checksum_.add({&filter_up, 1});
        checksum_.add_zeros(stride);
    }

    void add_filtered_row() {
        const std::uint8_t* const begin = filtered_.data();
        const std::uint8_t* const end = begin + filtered_.size();
        const std::uint8_t* unchecked = begin;
        const std::uint8_t* i = begin;
        add_byte(deflater_, *i++);
        while (i < end) {
            std::uint16_t distance = 1;
            std::size_t length = run_length(i, distance, end);
            if (length < shortest_repetition && i - begin >= pixel_bytes) {
                distance = pixel_bytes;
                length = run_length(i, distance, end);
            }
            if (length < shortest_repetition) {
                add_byte(deflater_, *i++);
                continue;
            }
            length = add_run(deflater_, length, distance);
            if (distance == 1 && *i == 0 && length >= worth_skipping) {
                checksum_.add({unchecked, i});
                checksum_.add_zeros(length);
                unchecked = i + length;
            }
            i += length;
        }
        checksum_.add({unchecked, end});
    }

    Deflater deflater_{zlib_header()};
    Adler32 checksum_;
    std::vector<std::uint8_t> filtered_;
};

// Finds where a text has been before: places are chained from the latest back by a hash of the bytes there.
class Repetitions {
  public:
    explicit Repetitions(Bytes text) : text_(text), latest_(hashes, none), earlier_(text.size(), none) {}

    // The longest repetition at `place`, the nearest of equals; length 0 where there is none.
    Token longest(std::size_t place) const {
        Token best;
        if (text_.size() - place < hashed_bytes) return best;
        const std::size_t limit = std::min<std::size_t>(text_.size() - place, longest_repetition);
        std::uint32_t other = latest_[hash(place)];
        for (int tries = 0; tries < most_tries && other != none; ++tries, other = earlier_[other]) {
            if (place - other > farthest_repetition) break;
            const auto here = text_.subspan(place, limit);
            const auto end = std::ranges::mismatch(here, text_.subspan(other, limit)).in1;
            const auto length = static_cast<std::uint16_t>(end - here.begin());
            if (length < hashed_bytes || length <= best.length) continue;
            best = {length, static_cast<std::uint16_t>(place - other)};
        }
        return best;
    }

    void remember(std::size_t place) {
        if (text_.size() - place < hashed_bytes) return;
        std::uint32_t& latest = latest_[hash(place)];
        earlier_[place] = latest;
        latest = static_cast<std::uint32_t>(place);
    }

  private:
    static constexpr std::size_t hashed_bytes = 4;
    static constexpr std::size_t hashes = 4096;
    static constexpr std::uint32_t none = 0xffffffff;
    static constexpr int most_tries = 64;

    // Multiplicative: D. E. Knuth, The Art of Computer Programming 3, 2nd edition, 1998, section 6.4.
    std::size_t hash(std::size_t place) const {
        std::uint32_t bytes = 0;
        for (std::size_t i = 0; i < hashed_bytes; ++i) bytes = bytes << 8 | text_[place + i];
        return bytes * 2654435769U >> 20;
    }

    Bytes text_;
    std::vector<std::uint32_t> latest_;   // place, by hash
    std::vector<std::uint32_t> earlier_;  // the place before with the same hash, by place
};

}  // namespace

std::vector<std::uint8_t> zlib_stream_of_rows(const Image& image) {
    const std::size_t stride = 3 * static_cast<std::size_t>(image.width);
    const std::vector<std::uint8_t> nothing(stride, 0);  // above the first row
    RowCompressor compressor(stride);
    for (std::size_t begin = 0; begin < image.rgb.size(); begin += stride) {
        compressor.add_row(&image.rgb[begin], begin == 0 ? nothing.data() : &image.rgb[begin - stride]);
    }
    return compressor.finish();
}

std::vector<std::uint8_t> zlib_stream_of_text(std::span<const std::uint8_t> text) {
    Deflater deflater(zlib_header());
    Repetitions repetitions(text);
    for (std::size_t i = 0; i < text.size();) {
        const Token repetition = repetitions.longest(i);
        const std::size_t length = std::max<std::size_t>(repetition.length, 1);
        deflater.add(repetition.length > 0 ? repetition : Token{0, text[i]});
        for (const std::size_t end = i + length; i < end; ++i) repetitions.remember(i);
    }
    Adler32 checksum;
    checksum.add(text);
    return finished(deflater, checksum);
}

}  // namespace ropesim
