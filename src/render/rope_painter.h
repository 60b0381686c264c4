#pragma once

#include "image/image.h"
#include "render/capsules.h"
#include "render/gl.h"

#include <vector>

namespace ropesim {

// Draws ropes, each as the union of its capsules: where they meet, the greatest coverage counts, once.
class RopePainter {
  public:
    // Throws std::runtime_error where a shader does not compile.
    RopePainter(const Gl& gl, int width, int height);

    // One rope over what is there. Needs zero alpha under it and leaves it so.
    void paint(const std::vector<Capsule>& capsules, Color color) const;

  private:
    const Gl& gl_;
    GLuint program_;
    GLint color_;
    GLuint vertices_ = 0;
    GLuint buffer_ = 0;
};

}  // namespace ropesim
