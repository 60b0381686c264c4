#include "image/zlib_stream.h"

#include "image/deflate.h"

#include <algorithm>
#include <utility>

namespace ropesim {

namespace {

using Bytes = std::span<const std::uint8_t>;

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

// Deflate, a window of 32 KB, no dictionary, fastest level; a multiple of 31 (section 2.2).
void append_zlib_header(std::vector<std::uint8_t>& stream) {
    stream.insert(stream.end(), {0x78, 0x01});
}

void append_checksum(std::vector<std::uint8_t>& stream, const Adler32& checksum) {
    for (int shift = 24; shift >= 0; shift -= 8)
        stream.push_back(static_cast<std::uint8_t>(checksum.value() >> shift));
}

std::vector<std::uint8_t> zlib_stream_of_text(std::span<const std::uint8_t> text) {
    std::vector<std::uint8_t> stream;
    append_zlib_header(stream);
    Deflater deflater(std::move(stream));
    Repetitions repetitions(text);
    for (std::size_t i = 0; i < text.size();) {
        const Token repetition = repetitions.longest(i);
        const std::size_t length = std::max<std::size_t>(repetition.length, 1);
        deflater.add(repetition.length > 0 ? repetition : Token{0, text[i]});
        for (const std::size_t end = i + length; i < end; ++i) repetitions.remember(i);
    }
    Adler32 checksum;
    checksum.add(text);
    stream = deflater.finish();
    append_checksum(stream, checksum);
    return stream;
}

}  // namespace ropesim
