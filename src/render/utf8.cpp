#include "render/utf8.h"

#include <cstddef>

namespace ropesim {
namespace {

constexpr char32_t replacement = U'\uFFFD';

// What a first byte announces: bytes that follow, its own bits, and what the second byte may be.
struct Lead {
    int following;
    char32_t bits;
    unsigned char lowest = 0x80;
    unsigned char highest = 0xBF;
};

// following is -1 where no character begins with this byte.
Lead lead(unsigned char byte) {
    if (byte < 0x80) return {0, byte};
    if (byte < 0xC2 || byte > 0xF4) return {-1, 0};
    if (byte < 0xE0) return {1, byte & 0x1FU};
    if (byte == 0xE0) return {2, byte & 0x0FU, 0xA0, 0xBF};  // shorter forms exist
    if (byte == 0xED) return {2, byte & 0x0FU, 0x80, 0x9F};  // surrogates
    if (byte < 0xF0) return {2, byte & 0x0FU};
    if (byte == 0xF0) return {3, byte & 0x07U, 0x90, 0xBF};  // shorter forms exist
    if (byte == 0xF4) return {3, byte & 0x07U, 0x80, 0x8F};  // past U+10FFFF
    return {3, byte & 0x07U};
}

// The character at `position`, which moves past it.
char32_t next(std::string_view text, std::size_t& position) {
    Lead first = lead(static_cast<unsigned char>(text[position++]));
    if (first.following < 0) return replacement;
    char32_t character = first.bits;
    for (int i = 0; i < first.following; ++i) {
        const unsigned char byte = position < text.size() ? static_cast<unsigned char>(text[position]) : 0;
        if (byte < first.lowest || byte > first.highest) return replacement;
        character = character << 6 | (byte & 0x3FU);
        first.lowest = 0x80;
        first.highest = 0xBF;
        ++position;
    }
    return character;
}

}  // namespace

std::u32string decode_utf8(std::string_view text) {
    std::u32string characters;
    for (std::size_t position = 0; position < text.size();) characters += next(text, position);
    return characters;
}

}  // namespace ropesim
