#include "clip/contact_sheet.h"

#include <algorithm>

namespace ropesim {
namespace {

constexpr int gap = 2;  // pixels
constexpr Color line = {96, 96, 96};

}  // namespace

Image contact_sheet(const std::vector<std::vector<SheetCell>>& rows, int width, int height,
                    const Camera& camera, Color background) {
    std::size_t longest = 0;
    for (const auto& row : rows) longest = std::max(longest, row.size());
    const auto columns = static_cast<int>(longest);
    Image sheet =
        filled(columns * (width + gap) - gap, static_cast<int>(rows.size()) * (height + gap) - gap, line);
    const Image empty = filled(width, height, background);
    for (int row = 0; row < static_cast<int>(rows.size()); ++row) {
        const std::vector<SheetCell>& cells = rows[static_cast<std::size_t>(row)];
        for (int column = 0; column < columns; ++column) {
            const int left = column * (width + gap);
            const int top = row * (height + gap);
            if (column >= static_cast<int>(cells.size())) {
                paste(empty, sheet, left, top);
                continue;
            }
            const SheetCell& cell = cells[static_cast<std::size_t>(column)];
            Renderer renderer(width, height, camera, background, cell.words);
            paste(renderer.draw(cell.ropes), sheet, left, top);
        }
    }
    return sheet;
}

}  // namespace ropesim
