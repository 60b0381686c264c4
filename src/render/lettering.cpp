#include "render/lettering.h"

#include "embedded_fonts.h"
#include "render/utf8.h"

#include <ft2build.h>
#include FT_FREETYPE_H

#include <algorithm>
#include <new>
#include <stdexcept>
#include <string>

namespace ropesim {
namespace {

constexpr char32_t ellipsis = U'\u2026';
constexpr FT_Int32 unhinted = FT_LOAD_NO_HINTING | FT_LOAD_NO_BITMAP;

void check(FT_Error error) {
    if (FT_ERROR_BASE(error) == FT_Err_Out_Of_Memory) throw std::bad_alloc();
    if (error) throw std::runtime_error("FreeType cannot set words: error " + std::to_string(error));
}

// FreeType counts in 64ths of a pixel.
constexpr int pixels(FT_Pos position) {
    return static_cast<int>((position + 32) >> 6);
}
constexpr int pixels_up(FT_Pos position) {
    return static_cast<int>((position + 63) >> 6);
}

// The compiled-in font at one size.
class Font {
  public:
    explicit Font(int size) {
        check(FT_Init_FreeType(&library_));
        const std::string_view file = embedded_fonts().front().second;
        try {
            check(FT_New_Memory_Face(library_, reinterpret_cast<const FT_Byte*>(file.data()),
                                     static_cast<FT_Long>(file.size()), 0, &face_));
            check(FT_Set_Pixel_Sizes(face_, 0, static_cast<FT_UInt>(size)));
        } catch (...) {
            FT_Done_FreeType(library_);
            throw;
        }
    }
    ~Font() { FT_Done_FreeType(library_); }
    Font(const Font&) = delete;
    Font& operator=(const Font&) = delete;

    // Loads the letter and gives how far it moves the pen, in 64ths of a pixel.
    FT_Pos load(char32_t character) const {
        check(FT_Load_Char(face_, character, unhinted));
        return face_->glyph->linearHoriAdvance >> 10;
    }

    // The picture of the letter that was loaded.
    const FT_GlyphSlotRec& draw() const {
        check(FT_Render_Glyph(face_->glyph, FT_RENDER_MODE_NORMAL));
        return *face_->glyph;
    }

    int ascent() const { return pixels_up(face_->size->metrics.ascender); }
    int descent() const { return pixels_up(-face_->size->metrics.descender); }

  private:
    FT_Library library_ = nullptr;
    FT_Face face_ = nullptr;
};

FT_Pos width(const Font& font, const std::u32string& characters) {
    FT_Pos pen = 0;
    for (const char32_t character : characters) pen += font.load(character);
    return pen;
}

// Without its last letters, ending in an ellipsis, where it is wider than `widest` pixels.
std::u32string cut(const Font& font, std::u32string characters, int widest) {
    if (pixels_up(width(font, characters)) <= widest) return characters;
    FT_Pos pen = font.load(ellipsis);
    std::size_t kept = 0;
    while (kept < characters.size()) {
        pen += font.load(characters[kept]);
        if (pixels_up(pen) > widest) break;
        ++kept;
    }
    characters.resize(kept);
    while (!characters.empty() && characters.back() == U' ') characters.pop_back();
    return characters + ellipsis;
}

// Lays a letter's picture into the line, its left end and baseline at the given pixel.
void lay(const FT_GlyphSlotRec& letter, int pen, int baseline, Lettering& line) {
    const FT_Bitmap& bitmap = letter.bitmap;
    for (int row = 0; row < static_cast<int>(bitmap.rows); ++row) {
        for (int column = 0; column < static_cast<int>(bitmap.width); ++column) {
            const int x = pen + letter.bitmap_left + column;
            const int y = baseline - letter.bitmap_top + row;
            if (x < 0 || x >= line.width || y < 0 || y >= line.height) continue;
            const std::size_t row_begin = static_cast<std::size_t>(y) * static_cast<std::size_t>(line.width);
            std::uint8_t& covered = line.coverage[row_begin + static_cast<std::size_t>(x)];
            covered = std::max(covered, bitmap.buffer[row * bitmap.pitch + column]);
        }
    }
}

Lettering set_line(const Font& font, std::string_view text, int widest) {
    const std::u32string characters = cut(font, decode_utf8(text), widest);
    Lettering line;
    line.width = std::clamp(pixels_up(width(font, characters)), 0, std::max(widest, 0));
    line.height = font.ascent() + font.descent();
    line.coverage.resize(static_cast<std::size_t>(line.width) * static_cast<std::size_t>(line.height));
    FT_Pos pen = 0;
    for (const char32_t character : characters) {
        const FT_Pos advance = font.load(character);
        lay(font.draw(), pixels(pen), font.ascent(), line);
        pen += advance;
    }
    return line;
}

}  // namespace

std::vector<Lettering> set_lines(const std::vector<std::string_view>& lines, int size, int widest) {
    const Font font(size);
    std::vector<Lettering> set;
    for (const std::string_view line : lines) set.push_back(set_line(font, line, widest));
    return set;
}

std::string lettering_library() {
    FT_Library library;
    check(FT_Init_FreeType(&library));
    FT_Int major = 0, minor = 0, patch = 0;
    FT_Library_Version(library, &major, &minor, &patch);
    FT_Done_FreeType(library);
    return "FreeType " + std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}

}  // namespace ropesim
