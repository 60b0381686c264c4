#include "render/rope_painter.h"

#include "render/shader.h"

#include <cstddef>

namespace ropesim {

RopePainter::RopePainter(const Gl& gl, int width, int height)
    : gl_(gl), program_(embedded_program(gl, "rope")), color_(uniform(gl, program_, "color")) {
    gl.UseProgram(program_);
    gl.Uniform2f(uniform(gl, program_, "picture"), static_cast<float>(width), static_cast<float>(height));

    gl.GenVertexArrays(1, &vertices_);
    gl.BindVertexArray(vertices_);
    gl.GenBuffers(1, &buffer_);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer_);
    constexpr GLuint segment = 0;
    constexpr GLuint radius = 1;
    gl.VertexAttribPointer(segment, 4, GL_FLOAT, GL_FALSE, sizeof(Capsule), nullptr);
    gl.VertexAttribPointer(radius, 1, GL_FLOAT, GL_FALSE, sizeof(Capsule),
                           reinterpret_cast<const void*>(offsetof(Capsule, radius)));
    for (const GLuint attribute : {segment, radius}) {
        gl.EnableVertexAttribArray(attribute);
        gl.VertexAttribDivisor(attribute, 1);
    }
}

// Two passes over the same quads. The first gathers the greatest coverage in the framebuffer's alpha.
// The second blends the colour by that alpha and sets it to zero, so that where quads overlap only the
// first of them changes the picture.
void RopePainter::paint(const std::vector<Capsule>& capsules, Color color) const {
    if (capsules.empty()) return;
    const auto count = static_cast<GLsizei>(capsules.size());
    gl_.UseProgram(program_);
    gl_.Uniform3f(color_, static_cast<float>(color[0]) / 255.0F, static_cast<float>(color[1]) / 255.0F,
                  static_cast<float>(color[2]) / 255.0F);
    gl_.BindVertexArray(vertices_);
    gl_.BindBuffer(GL_ARRAY_BUFFER, buffer_);
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(capsules.size() * sizeof(Capsule)),
                   capsules.data(), GL_STREAM_DRAW);
    gl_.Enable(GL_BLEND);

    gl_.ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
    gl_.BlendEquation(GL_MAX);
    gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);

    gl_.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gl_.BlendEquation(GL_FUNC_ADD);
    gl_.BlendFuncSeparate(GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA, GL_ZERO, GL_ZERO);
    gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, count);
}

}  // namespace ropesim
