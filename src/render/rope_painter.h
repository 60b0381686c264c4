#pragma once

#include "render/capsules.h"
#include "render/gl.h"

#include <vector>

namespace ropesim {

// Draws the coverage of ropes, each as the union of its capsules: where they meet, the greatest counts, once.
class RopePainter {
  public:
    // Throws std::runtime_error where a shader does not compile.
    RopePainter(const Gl& gl, int width, int height);

    // Up to four ropes at once, each in a channel of its own.
    void paint(const std::vector<Capsule>& capsules) const;

  private:
    const Gl& gl_;
};

}  // namespace ropesim
