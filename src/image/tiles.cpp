#include "image/tiles.h"

#include <algorithm>

namespace ropesim {

Tiles::Tiles(int width, int height)
    : width_(width),
      height_(height),
      columns_((width + tile_side - 1) / tile_side),
      rows_((height + tile_side - 1) / tile_side),
      marks_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0) {}

bool Tiles::any_in_rows(int first, int last) const {
    const auto begin = marks_.begin() + static_cast<std::ptrdiff_t>(index(0, first));
    const auto end = marks_.begin() + static_cast<std::ptrdiff_t>(index(0, last + 1));
    return std::find(begin, end, 1) != end;
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

void Tiles::append_runs(int first, int last, std::vector<PixelBox>& boxes) const {
    const int top = first * tile_side;
    const int bottom = std::min((last + 1) * tile_side, height_);
    const auto any = [&](int column) {
        for (int row = first; row <= last; ++row)
            if (contains(column, row)) return true;
        return false;
    };
    for (int column = 0; column < columns_; ++column) {
        if (!any(column)) continue;
        const int left = column * tile_side;
        while (column < columns_ && any(column)) ++column;
        boxes.push_back({left, top, std::min(column * tile_side, width_), bottom});
    }
}

std::vector<PixelBox> Tiles::runs() const {
    std::vector<PixelBox> boxes;
    for (int row = 0; row < rows_; ++row)
        if (any_in_rows(row, row)) append_runs(row, row, boxes);
    return boxes;
}

}  // namespace ropesim
