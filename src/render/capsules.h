#pragma once

#include "image/tiles.h"
#include "render/renderer.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ropesim {

// All points within a radius of a segment: a link, or with zero length a mass. In pixels from the
// picture's top left corner, y down; pixel (0, 0) has its centre at (0.5, 0.5). Laid out as the rope
// shader reads it.
struct Capsule {
    std::array<float, 2> begin;
    std::array<float, 2> end;
    float radius;
    std::array<std::uint8_t, 4> channel;  // 255 in the channel of the framebuffer that its coverage goes to
};

// Appends the links and masses of a polyline that reach into a picture of width x height pixels, cut to the
// picture and a margin that their coverage does not reach across, and adds the tiles that they may cover.
void append_capsules(const Polyline& polyline, std::size_t channel, const Camera& camera, int width,
                     int height, std::vector<Capsule>& capsules, Tiles& covered);

}  // namespace ropesim
