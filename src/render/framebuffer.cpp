#include "render/framebuffer.h"

#include "image/tiles.h"

#include <sys/mman.h>
#include <algorithm>
#include <array>
#include <new>
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

// The driver crashes where memory runs out as it draws. It takes the picture, and tens of megabytes for its
// code and its lists, whatever the size: whether that much is there is asked before.
void check_memory(int width, int height) {
    constexpr std::size_t drivers = 40 << 20;
    const std::size_t bytes =
        drivers + 4 * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    void* const room = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (room == MAP_FAILED) throw std::bad_alloc();
    ::munmap(room, bytes);
}

}  // namespace

Framebuffer::Framebuffer(const Gl& gl, int width, int height) : gl_(gl) {
    check_size(gl, width, height);
    check_memory(width, height);
    empty_ = bound_framebuffer(gl, width, std::min(height, tile_side));
    gl.ClearColor(0.0F, 0.0F, 0.0F, 0.0F);
    gl.Clear(GL_COLOR_BUFFER_BIT);
    drawn_ = bound_framebuffer(gl, width, height);
    gl.Viewport(0, 0, width, height);
}

void Framebuffer::clear(std::span<const PixelBox> boxes) const {
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, empty_);
    for (const PixelBox& box : boxes)
        gl_.BlitFramebuffer(box.left, 0, box.right, box.bottom - box.top, box.left, box.top, box.right,
                            box.bottom, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl_.BindFramebuffer(GL_READ_FRAMEBUFFER, drawn_);
}

std::span<const std::uint8_t> Framebuffer::read(const PixelBox& box) {
    const int width = box.right - box.left;
    const int height = box.bottom - box.top;
    coverage_.resize(channels * static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
    gl_.ReadPixels(box.left, box.top, width, height, GL_RGBA, GL_UNSIGNED_BYTE, coverage_.data());
    return coverage_;
}

}  // namespace ropesim
