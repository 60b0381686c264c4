#pragma once

#include <string>
#include <string_view>

namespace ropesim {

// The characters of UTF-8 text. Bytes that are no UTF-8 (The Unicode Standard, 15.0, section 3.9, table
// 3-7) become U+FFFD, one for each longest start of a character.
std::u32string decode_utf8(std::string_view text);

}  // namespace ropesim
