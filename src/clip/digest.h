#pragma once

#include "clip/file.h"

#include <string>
#include <string_view>

namespace ropesim {

// 128 bits of the bytes as 32 hexadecimal digits (XXH3).
std::string digest(std::string_view bytes);

// The same of a regular file, which is not kept. Throws std::runtime_error where it cannot be read.
std::string digest(const OpenFile& file);

}  // namespace ropesim
