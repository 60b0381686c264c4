#include "render/renderer.h"

#include "render/capsules.h"
#include "render/context.h"
#include "render/framebuffer.h"
#include "render/gl.h"
#include "render/mix.h"
#include "render/rope_painter.h"
#include "render/words_painter.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace ropesim {

namespace {

constexpr std::size_t channels = Framebuffer::channels;

// Ropes that are drawn at once, each in a channel of its own.
struct Group {
    std::vector<Capsule> capsules;
    std::vector<Color> colors;
    Tiles covered;
};

std::uint8_t* pixels_from(Image& image, int x, int y) {
    return &image.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                           static_cast<std::size_t>(x))];
}

// Mixes colours into a row of pixels, one for each channel of coverage, in their order. One colour after the
// other, which then stays in registers.
void mix_row(std::span<const Color> colors, const std::uint8_t* coverage, int pixels, std::uint8_t* rgb) {
    for (std::size_t channel = 0; channel < colors.size(); ++channel) {
        const Color color = colors[channel];
        for (std::size_t i = 0; i < static_cast<std::size_t>(pixels); ++i) {
            const std::uint8_t covered = coverage[channels * i + channel];
            if (covered > 0) mix(color, covered, rgb + 3 * i);
        }
    }
}

// Looks at all bytes, which is faster than looking for one.
bool covers_any(const std::uint8_t* coverage, int pixels) {
    std::uint8_t any = 0;
    for (int i = 0; i < static_cast<int>(channels) * pixels; ++i) any |= coverage[i];
    return any != 0;
}

// mix_row in a box of the picture, most of which nothing covers.
void mix_box(std::span<const Color> colors, const std::uint8_t* coverage, const PixelBox& box, Image& image) {
    constexpr int at_once = 16;  // pixels
    for (int y = box.top; y < box.bottom; ++y) {
        for (int x = box.left; x < box.right; x += at_once) {
            const int pixels = std::min(at_once, box.right - x);
            if (covers_any(coverage, pixels)) mix_row(colors, coverage, pixels, pixels_from(image, x, y));
            coverage += channels * static_cast<std::size_t>(pixels);
        }
    }
}

// Puts a row of pixels into every row of a box.
void fill(const std::vector<std::uint8_t>& row, const PixelBox& box, Image& image) {
    const auto bytes = 3 * static_cast<std::size_t>(box.right - box.left);
    for (int y = box.top; y < box.bottom; ++y)
        std::memcpy(pixels_from(image, box.left, y), row.data(), bytes);
}

}  // namespace

struct Renderer::Parts {
    Parts(int width, int height, const Camera& seen, Color background, std::span<const Words> words)
        : camera(seen),
          context(make_context()),
          gl(load_gl(*context)),
          framebuffer(gl, width, height),
          rope_painter(gl, width, height),
          words_painter(width, height, words),
          image(filled(width, height, background)),
          empty_row(image.rgb.begin(), image.rgb.begin() + 3L * width),
          ropes(words_painter.covered()),  // so that the first picture changes them
          inked(width, height),
          changed(width, height) {}

    std::vector<Group> grouped(std::span<const Polyline> polylines) const;
    void draw(const Group& group);

    Camera camera;
    std::unique_ptr<OffscreenContext> context;
    Gl gl;
    Framebuffer framebuffer;
    RopePainter rope_painter;
    WordsPainter words_painter;
    Image image;
    std::vector<std::uint8_t> empty_row;  // of the image: background
    Tiles ropes;                          // that ropes may cover
    Tiles inked;                          // that ropes or words may cover
    Tiles changed;                        // that may differ from the picture before
};

std::vector<Group> Renderer::Parts::grouped(std::span<const Polyline> polylines) const {
    std::vector<Group> groups;
    for (const Polyline& polyline : polylines) {
        if (groups.empty() || groups.back().colors.size() == channels)
            groups.push_back({{}, {}, Tiles(image.width, image.height)});
        Group& group = groups.back();
        append_capsules(polyline, group.colors.size(), camera, image.width, image.height, group.capsules,
                        group.covered);
        group.colors.push_back(polyline.color);
    }
    return groups;
}

void Renderer::Parts::draw(const Group& group) {
    const std::vector<PixelBox> boxes = group.covered.runs();
    framebuffer.clear(boxes);
    rope_painter.paint(group.capsules);
    for (const PixelBox& box : boxes) mix_box(group.colors, framebuffer.read(box).data(), box, image);
}

Renderer::Renderer(int width, int height, const Camera& camera, Color background,
                   std::span<const Words> words)
    : parts_(std::make_unique<Parts>(width, height, camera, background, words)) {}

Renderer::~Renderer() = default;

// Only what the ropes may cover, in this picture or the one before, is drawn anew.
const Image& Renderer::draw(std::span<const Polyline> polylines) {
    Parts& parts = *parts_;
    const std::vector<Group> groups = parts.grouped(polylines);
    parts.changed = parts.ropes;
    parts.ropes.clear();
    for (const Group& group : groups) parts.ropes.add(group.covered);
    parts.changed.add(parts.ropes);
    parts.inked = parts.ropes;
    parts.inked.add(parts.words_painter.covered());

    const std::vector<PixelBox> boxes = parts.changed.runs();
    for (const PixelBox& box : boxes) fill(parts.empty_row, box, parts.image);
    parts.context->make_current();
    for (const Group& group : groups) parts.draw(group);
    if (const GLenum error = parts.gl.GetError(); error != GL_NO_ERROR) {
        throw std::runtime_error("the OpenGL driver failed to draw: error " + std::to_string(error));
    }
    for (const PixelBox& box : boxes) parts.words_painter.paint(box, parts.image);
    return parts.image;
}

const Tiles& Renderer::inked() const {
    return parts_->inked;
}

const Tiles& Renderer::changed() const {
    return parts_->changed;
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
