#pragma once

#include "image/image.h"

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ropesim {

// Text chunks of a PNG: keyword (1 to 79 Latin-1 characters) to UTF-8 text.
using Texts = std::map<std::string, std::string>;

// The picture as a PNG file, 8-bit RGB, with the texts ahead of the pixels (iTXt; compressed where that
// is shorter). Same picture and texts, same bytes, on every machine.
std::vector<std::uint8_t> encode_png(const Image& image, const Texts& texts);

// Reads a PNG of any colour type and depth as 8-bit RGB (alpha is laid over black). Throws
// std::runtime_error, "<name>: what was found, what was expected", where the bytes are no whole PNG.
Image decode_png(std::span<const std::uint8_t> bytes, std::string_view name);

// The text chunks alone, without unpacking the pixels; tEXt, zTXt and iTXt. Throws as decode_png does;
// a file that was cut off anywhere (no IEND chunk at its end) is refused too.
Texts decode_png_texts(std::span<const std::uint8_t> bytes, std::string_view name);

// Whether the bytes begin as every PNG does.
bool is_png(std::span<const std::uint8_t> bytes);

}  // namespace ropesim
