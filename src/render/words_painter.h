#pragma once

#include "render/gl.h"
#include "render/pixel_box.h"
#include "render/renderer.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ropesim {

// Draws lines of words in the picture's top left corner.
class WordsPainter {
  public:
    // Throws std::runtime_error where a shader does not compile.
    WordsPainter(const Gl& gl, int width, int height, std::span<const Words> words);

    // The words over what is there; alpha stays as it is.
    void paint() const;

    // The pixels that they may cover, within the picture.
    const PixelBox& covered() const { return covered_; }

  private:
    struct Line {
        PixelBox box;     // in the picture; pixels
        int texture_row;  // of its top
        Color color;
    };

    void prepare(const std::vector<std::uint8_t>& coverage, int width, int height);

    const Gl& gl_;
    PixelBox covered_;
    std::vector<Line> lines_;
    GLuint program_ = 0;
    GLuint vertices_ = 0;
    GLuint texture_ = 0;
    GLint box_ = -1;
    GLint offset_ = -1;
    GLint color_ = -1;
};

}  // namespace ropesim
