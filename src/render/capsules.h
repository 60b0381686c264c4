#pragma once

#include "render/pixel_box.h"
#include "render/renderer.h"

#include <array>
#include <vector>

namespace ropesim {

// All points within a radius of a segment: a link, or with zero length a mass. In pixels from the
// picture's top left corner, y down; pixel (0, 0) has its centre at (0.5, 0.5). Laid out as the rope
// shader reads it.
struct Capsule {
    std::array<float, 2> begin;
    std::array<float, 2> end;
    float radius;
};

// Links and masses of a polyline that reach into a picture of width x height pixels, cut to the picture
// and a margin that their coverage does not reach across.
std::vector<Capsule> capsules(const Polyline& polyline, const Camera& camera, int width, int height);

// The pixels that capsules may cover, within the picture.
PixelBox covered(const std::vector<Capsule>& capsules, int width, int height);

}  // namespace ropesim
