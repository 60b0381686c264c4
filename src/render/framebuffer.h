#pragma once

#include "image/pixel_box.h"
#include "render/gl.h"

#include <cstdint>
#include <span>
#include <vector>

namespace ropesim {

// What is drawn into: for each pixel of the picture four channels of coverage, its top row first.
class Framebuffer {
  public:
    // How many ropes can be drawn at once.
    static constexpr std::size_t channels = 4;

    // Throws std::runtime_error where the driver allows no picture of this size (with its limit).
    Framebuffer(const Gl& gl, int width, int height);

    // Covers nothing in these boxes, none of which is higher than a tile.
    void clear(std::span<const PixelBox> boxes) const;

    // The coverage of a box that was cleared: its rows from the top, each byte 255 where all is covered.
    // Valid until the next call.
    std::span<const std::uint8_t> read(const PixelBox& box);

  private:
    const Gl& gl_;
    GLuint drawn_ = 0;
    GLuint empty_ = 0;  // a row of tiles; the driver clears a part by a shader, slower than this copies
    std::vector<std::uint8_t> coverage_;
};

}  // namespace ropesim
