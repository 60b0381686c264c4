#include "render/renderer.h"

#include "render/capsules.h"
#include "render/context.h"
#include "render/framebuffer.h"
#include "render/gl.h"
#include "render/rope_painter.h"
#include "render/words_painter.h"

#include <stdexcept>
#include <utility>

namespace ropesim {

struct Renderer::Parts {
    Parts(int width, int height, const Camera& seen, Color background, std::span<const Words> words)
        : camera(seen),
          context(make_context()),
          gl(load_gl(*context)),
          framebuffer(gl, width, height, background),
          rope_painter(gl, width, height),
          words_painter(gl, width, height, words),
          image(filled(width, height, background)),
          drawn{0, 0, width, height} {}

    Camera camera;
    std::unique_ptr<OffscreenContext> context;
    Gl gl;
    Framebuffer framebuffer;
    RopePainter rope_painter;
    WordsPainter words_painter;
    Image image;
    PixelBox drawn;  // where the framebuffer may hold something else than background and words
};

Renderer::Renderer(int width, int height, const Camera& camera, Color background,
                   std::span<const Words> words)
    : parts_(std::make_unique<Parts>(width, height, camera, background, words)) {}

Renderer::~Renderer() = default;

// Only what the ropes cover, in this picture or the one before, is cleared, drawn and read.
const Image& Renderer::draw(std::span<const Polyline> polylines) {
    Parts& parts = *parts_;
    Image& image = parts.image;
    std::vector<std::pair<std::vector<Capsule>, Color>> ropes;
    PixelBox ropes_box;
    for (const Polyline& polyline : polylines) {
        ropes.emplace_back(capsules(polyline, parts.camera, image.width, image.height), polyline.color);
        ropes_box = united(ropes_box, covered(ropes.back().first, image.width, image.height));
    }
    const PixelBox changed = united(parts.drawn, ropes_box);
    parts.drawn = ropes_box;
    if (changed.empty()) return image;

    parts.context->make_current();
    parts.framebuffer.begin(changed);
    for (const auto& [capsules, color] : ropes) parts.rope_painter.paint(capsules, color);
    if (!intersection(changed, parts.words_painter.covered()).empty()) parts.words_painter.paint();
    parts.framebuffer.read(changed, image);
    if (const GLenum error = parts.gl.GetError(); error != GL_NO_ERROR) {
        throw std::runtime_error("the OpenGL driver failed to draw: error " + std::to_string(error));
    }
    return image;
}

std::string Renderer::description() const {
    const auto text = [this](GLenum name) {
        return std::string(reinterpret_cast<const char*>(parts_->gl.GetString(name)));
    };
    // Such as "3.3 (Core Profile) Mesa 22.3.6".
    const std::string version = text(GL_VERSION);
    const std::string mesa = version.substr(version.rfind(' ') + 1);
    return std::string(parts_->context->kind()) + " " + mesa + ", " + text(GL_RENDERER) + ", OpenGL " +
           version.substr(0, version.find(' '));
}

}  // namespace ropesim
