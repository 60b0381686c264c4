#pragma once

#include "image/image.h"
#include "render/renderer.h"

#include <vector>

namespace ropesim {

// A picture on a sheet.
struct SheetCell {
    std::vector<Polyline> ropes;
    std::vector<Words> words;
};

// Pictures of one size and camera, side by side in rows, with a line between them. Rows may differ in length;
// where one is shorter the sheet is `background`. Throws as Renderer does.
Image contact_sheet(const std::vector<std::vector<SheetCell>>& rows, int width, int height,
                    const Camera& camera, Color background);

// The same of pictures that are there, all of one size, row by row of so many columns.
Image contact_sheet(const std::vector<Image>& cells, std::size_t columns, Color background);

}  // namespace ropesim
