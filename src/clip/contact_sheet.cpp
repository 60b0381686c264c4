#include "clip/contact_sheet.h"

#include <algorithm>

namespace ropesim {
namespace {

constexpr int gap = 2;  // pixels
constexpr Color line = {96, 96, 96};

}  // namespace

Image contact_sheet(const std::vector<Image>& cells, std::size_t columns, Color background) {
    const int width = cells.front().width;
    const int height = cells.front().height;
    const auto rows = static_cast<int>((cells.size() + columns - 1) / columns);
    Image sheet = filled(static_cast<int>(columns) * (width + gap) - gap, rows * (height + gap) - gap, line);
    const Image empty = filled(width, height, background);
    for (std::size_t i = 0; i < static_cast<std::size_t>(rows) * columns; ++i)
        paste(i < cells.size() ? cells[i] : empty, sheet, static_cast<int>(i % columns) * (width + gap),
              static_cast<int>(i / columns) * (height + gap));
    return sheet;
}

Image contact_sheet(const std::vector<std::vector<SheetCell>>& rows, int width, int height,
                    const Camera& camera, Color background) {
    std::size_t longest = 0;
    for (const auto& row : rows) longest = std::max(longest, row.size());
    std::vector<Image> cells;
    for (const auto& row : rows) {
        for (const SheetCell& cell : row) {
            Renderer renderer(width, height, camera, background, cell.words);
            cells.push_back(renderer.draw(cell.ropes));
        }
        cells.resize(cells.size() + longest - row.size(), filled(width, height, background));
    }
    return contact_sheet(cells, longest, background);
}

}  // namespace ropesim
