#pragma once

#include "image/image.h"
#include "image/tiles.h"
#include "render/lettering.h"
#include "render/renderer.h"

#include <span>
#include <vector>

namespace ropesim {

// Draws lines of words in the picture's top left corner.
class WordsPainter {
  public:
    WordsPainter(int width, int height, std::span<const Words> words);

    // The words over what is there, within a box of the picture.
    void paint(const PixelBox& box, Image& image) const;

    // The tiles that they may cover.
    const Tiles& covered() const { return covered_; }

  private:
    struct Line {
        PixelBox box;  // in the picture; its coverage may reach beyond
        Lettering lettering;
        Color color;
    };

    Tiles covered_;
    std::vector<Line> lines_;
};

}  // namespace ropesim
