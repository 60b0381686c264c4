#pragma once

#include "image/image.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ropesim {

// The pixels of a PNG: the picture's rows, each less the row above it (the filter Up of Portable Network
// Graphics, 2nd edition, 2003, section 9), as a zlib stream (RFC 1950). Made for frames that are one
// colour but for thin lines: it looks for runs of a byte and of a pixel and for nothing else, and is never
// much longer than the picture.
std::vector<std::uint8_t> zlib_stream_of_rows(const Image& image);

// A text as a zlib stream, repetitions found wherever they are.
std::vector<std::uint8_t> zlib_stream_of_text(std::span<const std::uint8_t> text);

}  // namespace ropesim
