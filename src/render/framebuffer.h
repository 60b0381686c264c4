#pragma once

#include "image/image.h"
#include "render/gl.h"
#include "render/pixel_box.h"

#include <cstdint>
#include <vector>

namespace ropesim {

// What is drawn into: RGBA bytes, the picture's top row first. Alpha is no part of the picture: the rope
// painter gathers coverage in it and leaves it zero.
class Framebuffer {
  public:
    // Throws std::runtime_error where the driver allows no picture of this size (with its limit).
    Framebuffer(const Gl& gl, int width, int height, Color background);

    // Fills the box with the background. What is drawn from here on changes nothing outside the box.
    void begin(const PixelBox& box) const;

    // Copies the box into the same place of an image of the same size.
    void read(const PixelBox& box, Image& image);

  private:
    const Gl& gl_;
    GLuint drawn_ = 0;
    GLuint empty_ = 0;  // background alone; the driver clears a part by a shader, slower than this copies
    std::vector<std::uint8_t> rgba_;
};

}  // namespace ropesim
