#include "render/framebuffer.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

namespace ropesim {
namespace {

std::string words(int width, int height) {
    return std::to_string(width) + "x" + std::to_string(height);
}

void check_size(const Gl& gl, int width, int height) {
    GLint side = 0;
    std::array<GLint, 2> viewport{};
    gl.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &side);
    gl.GetIntegerv(GL_MAX_VIEWPORT_DIMS, viewport.data());
    const int widest = std::min(side, viewport[0]);
    const int highest = std::min(side, viewport[1]);
    if (width >= 1 && height >= 1 && width <= widest && height <= highest) return;
    throw std::runtime_error("a picture of " + words(width, height) +
                             " pixels; the OpenGL driver draws 1x1 to " + words(widest, highest));
}

// A framebuffer object of the size, bound for drawing and reading.
GLuint bound_framebuffer(const Gl& gl, int width, int height) {
    GLuint colors = 0;
    gl.GenRenderbuffers(1, &colors);
    gl.BindRenderbuffer(GL_RENDERBUFFER, colors);
    gl.RenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, width, height);
    GLuint framebuffer = 0;
    gl.GenFramebuffers(1, &framebuffer);
    gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    gl.FramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colors);
    if (gl.GetError() != GL_NO_ERROR ||
        gl.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        throw std::runtime_error("the OpenGL driver has no memory for a picture of " + words(width, height) +
                                 " pixels");
    }
    return framebuffer;
}

// The first three of every four bytes.
void drop_alpha(const std::uint8_t* rgba, int pixels, std::uint8_t* rgb) {
    for (int i = 0; i < pixels; ++i) {
        for (int channel = 0; channel < 3; ++channel) rgb[3 * i + channel] = rgba[4 * i + channel];
    }
}

}  // namespace

Framebuffer::Framebuffer(const Gl& gl, int width, int height, Color background) : gl_(gl) {
    check_size(gl, width, height);
    empty_ = bound_framebuffer(gl, width, height);
    gl.ClearColor(static_cast<float>(background[0]) / 255.0F, static_cast<float>(background[1]) / 255.0F,
                  static_cast<float>(background[2]) / 255.0F, 0.0F);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    drawn_ = bound_framebuffer(gl, width, height);
    gl.Viewport(0, 0, width, height);
    gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
}

void Framebuffer::begin(const PixelBox& box) const {
    gl_.Disable(GL_SCISSOR_TEST);
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, empty_);
    gl_.BlitFramebuffer(box.left, box.top, box.right, box.bottom, box.left, box.top, box.right, box.bottom,
                        GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, drawn_);
    gl_.Enable(GL_SCISSOR_TEST);
    gl_.Scissor(box.left, box.top, box.right - box.left, box.bottom - box.top);
}

void Framebuffer::read(const PixelBox& box, Image& image) {
    const int width = box.right - box.left;
    const int height = box.bottom - box.top;
    const auto row_bytes = 4 * static_cast<std::size_t>(width);
    rgba_.resize(row_bytes * static_cast<std::size_t>(height));
    gl_.ReadPixels(box.left, box.top, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba_.data());
    for (int row = 0; row < height; ++row) {
        const auto first = static_cast<std::size_t>(box.top + row) * static_cast<std::size_t>(image.width) +
                           static_cast<std::size_t>(box.left);
        drop_alpha(rgba_.data() + row_bytes * static_cast<std::size_t>(row), width,
                   image.rgb.data() + 3 * first);
    }
}

}  // namespace ropesim
