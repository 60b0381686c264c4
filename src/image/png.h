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
// is shorter). Same picture and texts, same bytes, on every machine and with every release of the
// libraries. Throws std::runtime_error where a keyword is not of 1 to 79 characters, a keyword or text has
// a zero character, or the texts are larger than 64 MB together.
std::vector<std::uint8_t> encode_png(const Image& image, const Texts& texts);

// Reads a PNG of any colour type and depth as 8-bit RGB (alpha is laid over black; what the file says of
// gamma is not applied). Throws std::runtime_error, "<name>: what was found, what was expected", where the
// bytes are no whole PNG and nothing else, or the picture has more than 65535 pixels a side or 2^28 in all.
Image decode_png(std::span<const std::uint8_t> bytes, std::string_view name);

// The same with alpha laid over another colour than black.
Image decode_png(std::span<const std::uint8_t> bytes, std::string_view name, Color background);

// The text chunks alone, without unpacking the pixels; tEXt, zTXt and iTXt. Throws as decode_png does;
// a file that was cut off anywhere (no IEND chunk at its end) is refused too, and more than 64 MB of text.
// Of a keyword that comes twice, the first text counts.
Texts decode_png_texts(std::span<const std::uint8_t> bytes, std::string_view name);

// Whether the bytes begin as every PNG does.
bool is_png(std::span<const std::uint8_t> bytes);

// "libpng 1.6.39", the library that decodes.
std::string png_library();

}  // namespace ropesim
