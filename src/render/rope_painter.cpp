#include "render/rope_painter.h"

#include "render/shader.h"

#include <cstddef>

namespace ropesim {

// Its state is the only one in the context, and stays set.
RopePainter::RopePainter(const Gl& gl, int width, int height) : gl_(gl) {
    const GLuint program = embedded_program(gl, "rope");
    gl.UseProgram(program);
    gl.Uniform2f(uniform(gl, program, "picture"), static_cast<float>(width), static_cast<float>(height));

    GLuint vertices = 0;
    GLuint buffer = 0;
    gl.GenVertexArrays(1, &vertices);
    gl.BindVertexArray(vertices);
    gl.GenBuffers(1, &buffer);
    gl.BindBuffer(GL_ARRAY_BUFFER, buffer);
    constexpr GLuint segment = 0;
    constexpr GLuint radius = 1;
    constexpr GLuint channel = 2;
    gl.VertexAttribPointer(segment, 4, GL_FLOAT, GL_FALSE, sizeof(Capsule), nullptr);
    gl.VertexAttribPointer(radius, 1, GL_FLOAT, GL_FALSE, sizeof(Capsule),
                           reinterpret_cast<const void*>(offsetof(Capsule, radius)));
    gl.VertexAttribPointer(channel, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(Capsule),
                           reinterpret_cast<const void*>(offsetof(Capsule, channel)));
    for (const GLuint attribute : {segment, radius, channel}) {
        gl.EnableVertexAttribArray(attribute);
        gl.VertexAttribDivisor(attribute, 1);
    }
    gl.Enable(GL_BLEND);
    gl.BlendEquation(GL_MAX);
}

void RopePainter::paint(const std::vector<Capsule>& capsules) const {
    if (capsules.empty()) return;
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(capsules.size() * sizeof(Capsule)),
                   capsules.data(), GL_STREAM_DRAW);
    gl_.DrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, static_cast<GLsizei>(capsules.size()));
}

}  // namespace ropesim
