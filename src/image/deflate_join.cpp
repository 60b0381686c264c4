#include "image/deflate_join.h"

#include <zlib.h>

#include <array>
#include <cstddef>
#include <memory>
#include <new>
#include <span>
#include <stdexcept>

namespace ropesim {

namespace {

// A block of a deflate stream, in bits from the stream's beginning.
struct Block {
    std::size_t begin = 0;
    std::size_t end = 0;
};

// zlib unpacks the stream, and stops behind each block.
Block last_block(std::span<const std::uint8_t> stream) {
    constexpr int no_header = -15;  // nor a checksum; a window of 2^15 bytes
    constexpr int unused_bits = 7;  // of the last byte read: these bits of data_type say how many
    constexpr int behind_block = 128;
    std::array<std::uint8_t, 1 << 15> unpacked;
    z_stream state{};
    state.next_in = const_cast<std::uint8_t*>(stream.data());  // NOLINT(*-const-cast): zlib only reads it
    state.avail_in = static_cast<uInt>(stream.size());
    if (inflateInit2(&state, no_header) != Z_OK) throw std::bad_alloc();
    const std::unique_ptr<z_stream, int (*)(z_stream*)> ended(&state, inflateEnd);
    Block last;
    for (int status = Z_OK; status != Z_STREAM_END;) {
        state.next_out = unpacked.data();
        state.avail_out = static_cast<uInt>(unpacked.size());
        status = inflate(&state, Z_BLOCK);
        if (status == Z_MEM_ERROR) throw std::bad_alloc();
        if ((status != Z_OK && status != Z_STREAM_END) || (status == Z_STREAM_END && state.avail_in > 0))
            throw std::invalid_argument("no deflate stream, but one was to be continued");
        if (status == Z_OK && (state.data_type & behind_block) != 0)
            last = {last.end, 8 * state.total_in - static_cast<std::size_t>(state.data_type & unused_bits)};
    }
    return last;
}

}  // namespace

void make_continued(std::vector<std::uint8_t>& deflate_stream) {
    const Block last = last_block(deflate_stream);
    deflate_stream[last.begin / 8] &= static_cast<std::uint8_t>(~(1U << last.begin % 8));
    // Three zeros begin the stored block, and its length, 0, follows at the next byte and then inverted.
    const std::size_t unused = 8 * deflate_stream.size() - last.end;
    deflate_stream.back() &= static_cast<std::uint8_t>(0xffU >> unused);
    if (unused < 3) deflate_stream.push_back(0);
    constexpr std::array<std::uint8_t, 4> empty{0x00, 0x00, 0xff, 0xff};
    deflate_stream.insert(deflate_stream.end(), empty.begin(), empty.end());
}

}  // namespace ropesim
