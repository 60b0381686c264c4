#include "image/unpacked.h"

#include <zlib.h>

namespace ropesim {

std::vector<std::uint8_t> unpacked(const std::vector<std::uint8_t>& stream, std::size_t size) {
    std::vector<std::uint8_t> bytes(size + 1);
    z_stream state{};
    inflateInit2(&state, -15);
    state.next_in = const_cast<Bytef*>(stream.data());
    state.avail_in = static_cast<uInt>(stream.size());
    state.next_out = bytes.data();
    state.avail_out = static_cast<uInt>(bytes.size());
    const int status = inflate(&state, Z_FINISH);
    bytes.resize(status == Z_STREAM_END && state.avail_in == 0 ? state.total_out : 0);
    inflateEnd(&state);
    return bytes;
}

}  // namespace ropesim
