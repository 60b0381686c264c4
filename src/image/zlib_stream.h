#pragma once

#include "image/adler32.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ropesim {

// A zlib stream (RFC 1950) is a header of two bytes, a deflate stream and the checksum of what it unpacks to.
void append_zlib_header(std::vector<std::uint8_t>& stream);
void append_checksum(std::vector<std::uint8_t>& stream, const Adler32& checksum);

// A text as a zlib stream, repetitions found wherever they are.
std::vector<std::uint8_t> zlib_stream_of_text(std::span<const std::uint8_t> text);

}  // namespace ropesim
