#pragma once

#include "image/image.h"
#include "image/png.h"

#include <string>
#include <vector>

namespace ropesim {

// The same picture and texts as encode_png, in as few bytes as libdeflate makes of several ways to filter the
// rows, for a thousand times the time; other releases of libdeflate may give other bytes. Throws as
// encode_png does.
std::vector<std::uint8_t> encode_compact_png(const Image& image, const Texts& texts);

// "libdeflate 1.14", the library that compresses.
std::string compact_library();

}  // namespace ropesim
