#include "render/words_painter.h"

#include "render/lettering.h"
#include "render/shader.h"

#include <algorithm>
#include <cstddef>
#include <string_view>

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

// The lines' coverage, one below the other, in rows of `width` bytes.
std::vector<std::uint8_t> stacked(const std::vector<Lettering>& lines, int width) {
    std::vector<std::uint8_t> coverage;
    for (const Lettering& line : lines) {
        for (int row = 0; row < line.height; ++row) {
            const auto begin = line.coverage.begin() + row * line.width;
            coverage.insert(coverage.end(), begin, begin + line.width);
            coverage.resize(coverage.size() + static_cast<std::size_t>(width - line.width));
        }
    }
    return coverage;
}

}  // namespace

WordsPainter::WordsPainter(const Gl& gl, int width, int height, std::span<const Words> words) : gl_(gl) {
    const int size = letter_size(height);
    const int border = size / 2;
    std::vector<Lettering> letterings = set(words, size, width - 2 * border);
    std::size_t visible = 0;
    int row = 0;
    int widest = 0;
    for (const Lettering& line : letterings) {
        const int top = border + row;
        if (top >= height) break;
        lines_.push_back({{border, top, border + line.width, top + line.height}, row, words[visible].color});
        covered_ = united(covered_, lines_.back().box);
        widest = std::max(widest, line.width);
        row += line.height;
        ++visible;
    }
    covered_ = intersection(covered_, {0, 0, width, height});
    if (covered_.empty()) return;
    letterings.resize(visible);
    prepare(stacked(letterings, widest), widest, row);
    gl.Uniform2f(uniform(gl, program_, "picture"), static_cast<float>(width), static_cast<float>(height));
}

void WordsPainter::prepare(const std::vector<std::uint8_t>& coverage, int width, int height) {
    program_ = embedded_program(gl_, "words");
    gl_.UseProgram(program_);
    gl_.GenVertexArrays(1, &vertices_);
    gl_.GenTextures(1, &texture_);
    gl_.BindTexture(GL_TEXTURE_2D, texture_);
    gl_.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl_.TexImage2D(GL_TEXTURE_2D, 0, GL_R8, width, height, 0, GL_RED, GL_UNSIGNED_BYTE, coverage.data());
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    gl_.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    box_ = uniform(gl_, program_, "box");
    offset_ = uniform(gl_, program_, "offset");
    color_ = uniform(gl_, program_, "color");
}

void WordsPainter::paint() const {
    if (covered_.empty()) return;
    gl_.UseProgram(program_);
    gl_.BindVertexArray(vertices_);
    gl_.BindTexture(GL_TEXTURE_2D, texture_);
    gl_.Enable(GL_BLEND);
    gl_.BlendEquation(GL_FUNC_ADD);
    gl_.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ZERO, GL_ONE);
    for (const Line& line : lines_) {
        const PixelBox& box = line.box;
        gl_.Uniform4f(box_, static_cast<float>(box.left), static_cast<float>(box.top),
                      static_cast<float>(box.right - box.left), static_cast<float>(box.bottom - box.top));
        gl_.Uniform2i(offset_, -box.left, line.texture_row - box.top);
        gl_.Uniform3f(color_, static_cast<float>(line.color[0]) / 255.0F,
                      static_cast<float>(line.color[1]) / 255.0F, static_cast<float>(line.color[2]) / 255.0F);
        gl_.DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    }
}

}  // namespace ropesim
