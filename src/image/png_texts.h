#pragma once

#include "image/png.h"

#include <cstdint>
#include <string>
#include <vector>

namespace ropesim {

// Throws as encode_png does.
void check_texts(const Texts& texts);

// A whole iTXt chunk.
std::vector<std::uint8_t> text_chunk(const std::string& keyword, const std::string& text);

}  // namespace ropesim
