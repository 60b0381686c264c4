#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace ropesim {

// A line of words as coverage: rows from top to bottom, one byte a pixel, 255 where a letter covers it.
struct Lettering {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> coverage;
};

// Sets lines of UTF-8 text in DejaVu Sans (compiled in), letters unhinted and at whole pixels, each line
// `size` pixels high from the top of "d" to the bottom of "p" as the font's designers mean it (the em),
// with room above and below for accents. What is not UTF-8 shows as U+FFFD, what the font lacks as its
// box. A line wider than `widest` pixels is cut and ends in an ellipsis, and is never wider than that.
// Throws std::runtime_error where FreeType fails.
std::vector<Lettering> set_lines(const std::vector<std::string_view>& lines, int size, int widest);

// "FreeType 2.12.1", the library that draws the glyphs.
std::string lettering_library();

}  // namespace ropesim
