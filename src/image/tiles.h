#pragma once

#include "image/pixel_box.h"

#include <cstdint>
#include <vector>

namespace ropesim {

// Squares of pixels that a picture is cut into; those at its right and bottom edges may be smaller. Of 16,
// frames are as fast: there are fewer pixels to look at, but more calls of OpenGL.
inline constexpr int tile_side = 32;

// Some of a picture's tiles.
class Tiles {
  public:
    Tiles(int width, int height);  // of the picture, pixels; none of its tiles

    int columns() const { return columns_; }
    int rows() const { return rows_; }
    bool contains(int column, int row) const { return marks_[index(column, row)] != 0; }
    bool any_in_rows(int first, int last) const;

    void clear();
    void add(const Tiles& others);  // of a picture of the same size
    void add(const PixelBox& box);  // the tiles that it meets; the box may reach out of the picture

    // Appends the columns of rows `first` to `last` in which there are tiles as boxes in the picture, as high
    // as these rows, neighbours in one, from left to right.
    void append_runs(int first, int last, std::vector<PixelBox>& boxes) const;
    // The tiles as boxes, row by row.
    std::vector<PixelBox> runs() const;

  private:
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column);
    }

    int width_;
    int height_;
    int columns_;
    int rows_;
    std::vector<std::uint8_t> marks_;  // 0 or 1, row by row
};

}  // namespace ropesim
