#pragma once

#include "clip/positions.h"
#include "image/image.h"
#include "scene/scene.h"

#include <filesystem>
#include <functional>

namespace ropesim {

// Draws a frame of a clip and writes it to a file.
using MakeFrame = std::function<void(long frame, const std::filesystem::path& path)>;

// Made in the process that is to draw. The scene and the motion must outlive it.
using FrameMaker = MakeFrame (*)(const Scene& scene, const Positions& motion);

MakeFrame by_ropesim(const Scene& scene, const Positions& motion);

// Our pictures, encoded anew in every frame by libpng as it is.
MakeFrame by_libpng(const Scene& scene, const Positions& motion);

std::size_t size_by_libpng(const Image& image);

// As a careful user of cairo draws the same picture: one surface, round joins, then round points.
MakeFrame by_cairo(const Scene& scene, const Positions& motion);

// The same with OpenCV: anti-aliased lines and circles, imwrite as it is.
MakeFrame by_opencv(const Scene& scene, const Positions& motion);

// What ropesim does for a frame, one part after the other; microseconds for a frame, on average over the
// clip.
struct Stages {
    double clearing = 0.0;
    double drawing = 0.0;
    double reading = 0.0;
    double filtering = 0.0;
    double compressing = 0.0;
    double writing = 0.0;
    double whole = 0.0;  // as it is done, with what is between the parts

    double sum() const { return clearing + drawing + reading + filtering + compressing + writing; }
};
Stages stages(const Scene& scene, const Positions& motion, const std::filesystem::path& folder);

}  // namespace ropesim
