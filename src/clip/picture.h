#pragma once

#include "render/renderer.h"
#include "scene/scene.h"
#include "simulation/rope.h"

#include <memory>
#include <vector>

namespace ropesim {

// A renderer for the scene's size, view, background and words. Throws as Renderer's constructor does.
std::unique_ptr<Renderer> make_renderer(const Scene& scene);

// What to draw of a frame: the scene's ropes at these positions; a rope without rows is left out.
std::vector<Polyline> polylines(const Scene& scene, const std::vector<Points>& positions);

}  // namespace ropesim
