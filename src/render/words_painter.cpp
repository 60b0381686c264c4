#include "render/words_painter.h"

#include "render/mix.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>

namespace ropesim {
namespace {

// Pixels of the em: 18 at the usual height of 640, legible in small pictures and modest in large ones.
int letter_size(int picture_height) {
    return std::clamp(picture_height / 36, 10, 40);
}

std::vector<Lettering> set(std::span<const Words> words, int size, int widest) {
    std::vector<std::string_view> texts;
    for (const Words& line : words) texts.emplace_back(line.text);
    return set_lines(texts, size, widest);
}

std::size_t index(int x, int y, int width) {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
}

}  // namespace

WordsPainter::WordsPainter(int width, int height, std::span<const Words> words) : covered_(width, height) {
    const int size = letter_size(height);
    const int border = size / 2;
    std::vector<Lettering> letterings = set(words, size, width - 2 * border);
    int top = border;
    for (std::size_t i = 0; i < words.size() && top < height; ++i) {
        const PixelBox box{border, top, border + letterings[i].width, top + letterings[i].height};
        top = box.bottom;
        covered_.add(box);
        lines_.push_back({box, std::move(letterings[i]), words[i].color});
    }
}

void WordsPainter::paint(const PixelBox& box, Image& image) const {
    for (const auto& [at, lettering, color] : lines_) {
        const PixelBox part = intersection(at, box);
        if (part.empty()) continue;
        for (int y = part.top; y < part.bottom; ++y) {
            const std::uint8_t* const coverage =
                &lettering.coverage[index(part.left - at.left, y - at.top, lettering.width)];
            std::uint8_t* const pixels = &image.rgb[3 * index(part.left, y, image.width)];
            for (int i = 0; i < part.right - part.left; ++i) mix(color, coverage[i], pixels + 3L * i);
        }
    }
}

}  // namespace ropesim
