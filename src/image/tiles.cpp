#include "image/tiles.h"

#include <algorithm>

namespace ropesim {

Tiles::Tiles(int width, int height)
    : width_(width),
      height_(height),
      columns_((width + tile_side - 1) / tile_side),
      rows_((height + tile_side - 1) / tile_side),
      marks_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0) {}

bool Tiles::any_in_row(int row) const {
    const auto begin = marks_.begin() + static_cast<std::ptrdiff_t>(index(0, row));
    return std::find(begin, begin + columns_, 1) != begin + columns_;
}

void Tiles::clear() {
    std::ranges::fill(marks_, std::uint8_t{0});
}

void Tiles::add(const Tiles& others) {
    for (std::size_t i = 0; i < marks_.size(); ++i) marks_[i] |= others.marks_[i];
}

void Tiles::add(const PixelBox& box) {
    const PixelBox seen = intersection(box, {0, 0, width_, height_});
    if (seen.empty()) return;
    const int first = seen.left / tile_side;
    const int last = (seen.right - 1) / tile_side;
    for (int row = seen.top / tile_side; row <= (seen.bottom - 1) / tile_side; ++row)
        std::fill_n(marks_.begin() + static_cast<std::ptrdiff_t>(index(first, row)), last - first + 1,
                    std::uint8_t{1});
}

void Tiles::runs(int row, std::vector<PixelBox>& boxes) const {
    const auto begin = marks_.begin() + static_cast<std::ptrdiff_t>(index(0, row));
    const auto end = begin + columns_;
    const int top = row * tile_side;
    const int bottom = std::min(top + tile_side, height_);
    for (auto first = std::find(begin, end, 1); first != end;) {
        const auto last = std::find(first, end, 0);
        boxes.push_back({static_cast<int>(first - begin) * tile_side, top,
                         std::min(static_cast<int>(last - begin) * tile_side, width_), bottom});
        first = std::find(last, end, 1);
    }
}

std::vector<PixelBox> Tiles::runs() const {
    std::vector<PixelBox> boxes;
    for (int row = 0; row < rows_; ++row) runs(row, boxes);
    return boxes;
}

}  // namespace ropesim
