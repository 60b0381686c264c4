#include "image/deflate_join.h"

#include "image/unpacked.h"

#include <gtest/gtest.h>
#include <zlib.h>
#include <algorithm>
#include <stdexcept>

namespace ropesim {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr int no_header = -15;

// A bare deflate stream by zlib: level 0 stores, the strategy Z_FIXED takes the codes that need no table.
Bytes deflated(Bytes bytes, int level, int strategy) {
    z_stream state{};
    deflateInit2(&state, level, Z_DEFLATED, no_header, 8, strategy);
    Bytes stream(deflateBound(&state, bytes.size()));
    state.next_in = bytes.data();
    state.avail_in = static_cast<uInt>(bytes.size());
    state.next_out = stream.data();
    state.avail_out = static_cast<uInt>(stream.size());
    EXPECT_EQ(deflate(&state, Z_FINISH), Z_STREAM_END);
    stream.resize(state.total_out);
    deflateEnd(&state);
    return stream;
}

// Few values, so that codes are of few bits and streams end at every bit of a byte.
Bytes text(std::size_t size) {
    Bytes bytes(size);
    std::uint32_t state = static_cast<std::uint32_t>(size) + 1;
    std::ranges::generate(bytes, [&] {
        state = state * 1664525 + 1013904223;
        return static_cast<std::uint8_t>(state >> 30);
    });
    return bytes;
}

TEST(DeflateJoin, IsWhatTheStreamsHoldOneAfterTheOther) {
    for (const int level : {0, 1, 9}) {
        for (const int strategy : {Z_DEFAULT_STRATEGY, Z_FIXED, Z_HUFFMAN_ONLY}) {
            Bytes joined;
            Bytes expected;
            for (const std::size_t size : {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 1000, 70000, 300000}) {
                Bytes stream = deflated(text(size), level, strategy);
                make_continued(stream);
                joined.insert(joined.end(), stream.begin(), stream.end());
                const Bytes bytes = text(size);
                expected.insert(expected.end(), bytes.begin(), bytes.end());
                const Bytes last = deflated({'e', 'n', 'd'}, level, strategy);
                Bytes whole = joined;
                whole.insert(whole.end(), last.begin(), last.end());
                Bytes whole_expected = expected;
                whole_expected.insert(whole_expected.end(), {'e', 'n', 'd'});
                EXPECT_TRUE(unpacked(whole, whole_expected.size()) == whole_expected)
                    << "level " << level << ", strategy " << strategy << ", size " << size;
            }
        }
    }
}

// The bits behind the end of a block of the fixed codes: its header and 7 zeros are ten bits.
TEST(DeflateJoin, DoesNotMindWhatStandsInTheLastByteBehindTheStream) {
    Bytes stream{0x03, 0xfc};
    make_continued(stream);
    const Bytes last = deflated({'e', 'n', 'd'}, 9, Z_DEFAULT_STRATEGY);
    stream.insert(stream.end(), last.begin(), last.end());
    EXPECT_EQ(unpacked(stream, 3), (Bytes{'e', 'n', 'd'}));
}

TEST(DeflateJoin, RefusesWhatIsNoWholeStream) {
    Bytes cut = deflated(text(1000), 9, Z_DEFAULT_STRATEGY);
    cut.pop_back();
    Bytes nothing;
    Bytes invalid{0xff, 0xff};
    Bytes more = deflated(text(1000), 9, Z_DEFAULT_STRATEGY);
    more.push_back(0);
    for (Bytes* const stream : {&cut, &nothing, &invalid, &more})
        EXPECT_THROW(make_continued(*stream), std::invalid_argument);
}

}  // namespace
}  // namespace ropesim
