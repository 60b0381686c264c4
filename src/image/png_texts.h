#pragma once

#include "image/png.h"

#include <cstdint>
#include <vector>

namespace ropesim {

// Appends an iTXt chunk for each text. Throws as encode_png does.
void append_text_chunks(std::vector<std::uint8_t>& file, const Texts& texts);

}  // namespace ropesim
