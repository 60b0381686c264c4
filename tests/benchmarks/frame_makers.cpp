#include "benchmarks/frame_makers.h"

#include "clip/file.h"
#include "clip/frames.h"
#include "clip/manifest.h"
#include "clip/picture.h"
#include "image/frame_encoder.h"
#include "image/zlib_stream.h"
#include "render/capsules.h"
#include "render/framebuffer.h"
#include "render/rope_painter.h"

#include <cairo.h>
#include <png.h>

#include <fcntl.h>
#include <unistd.h>
#include <chrono>
#include <memory>
#include <stdexcept>

namespace ropesim {
namespace {

std::string steps_line(const Scene& scene) {
    return "Steps per frame: " + std::to_string(scene.steps_per_frame);
}

// From the world to the picture.
struct Pixels {
    explicit Pixels(const Scene& scene)
        : scale(scene.size[1] / scene.view.height),
          center(scene.view.center),
          half(scene.size[0] / 2.0, scene.size[1] / 2.0) {}

    double column(const Points& points, Eigen::Index mass) const {
        return half.x() + (points(mass, 0) - center.x()) * scale;
    }
    double row(const Points& points, Eigen::Index mass) const {
        return half.y() - (points(mass, 1) - center.y()) * scale;
    }

    double scale;
    Eigen::Array2d center;
    Eigen::Array2d half;
};

void set_color(cairo_t* cairo, const Color& color) {
    cairo_set_source_rgb(cairo, color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
}

void draw_words(cairo_t* cairo, const Scene& scene) {
    set_color(cairo, {255, 255, 255});
    cairo_select_font_face(cairo, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo, 18);
    cairo_move_to(cairo, 10, 24);
    cairo_show_text(cairo, scene.title.c_str());
    cairo_move_to(cairo, 10, 48);
    cairo_show_text(cairo, steps_line(scene).c_str());
}

void draw(cairo_t* cairo, const Scene& scene, const std::vector<Points>& ropes) {
    const Pixels pixels(scene);
    set_color(cairo, scene.background);
    cairo_paint(cairo);
    for (std::size_t i = 0; i < ropes.size(); ++i) {
        const SceneRope& rope = scene.ropes[i];
        const Points& points = ropes[i];
        set_color(cairo, rope.color);
        cairo_set_line_width(cairo, rope.line_width);
        cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
        for (Eigen::Index mass = 0; mass < points.rows(); ++mass)
            cairo_line_to(cairo, pixels.column(points, mass), pixels.row(points, mass));
        cairo_stroke(cairo);
        for (Eigen::Index mass = 0; mass < points.rows(); ++mass) {
            cairo_arc(cairo, pixels.column(points, mass), pixels.row(points, mass), rope.point_size / 2, 0,
                      6.2831853);
            cairo_fill(cairo);
        }
    }
    if (scene.words) draw_words(cairo, scene);
}

png_image libpng_image(const Image& image) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(image.width);
    png.height = static_cast<png_uint_32>(image.height);
    png.format = PNG_FORMAT_RGB;
    return png;
}

void write_by_libpng(const Image& image, const std::filesystem::path& path) {
    png_image png = libpng_image(image);
    if (png_image_write_to_file(&png, path.c_str(), 0, image.rgb.data(), 0, nullptr) == 0)
        throw std::runtime_error(png.message);
}

double microseconds() {
    return std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

// Adds to `time` what `run` takes.
template <class Run>
void measure(double& time, const Run& run) {
    const double begin = microseconds();
    run();
    time += microseconds() - begin;
}

}  // namespace

MakeFrame by_ropesim(const Scene& scene) {
    const std::shared_ptr<Renderer> renderer = make_renderer(scene);
    const auto encoder = std::make_shared<FrameEncoder>(scene.size[0], scene.size[1]);
    const auto texts = std::make_shared<Texts>(frame_texts(scene, ""));
    return [=, &scene](long frame, const std::vector<Points>& positions, const std::filesystem::path& path) {
        set_frame(*texts, frame);
        const Image& image = renderer->draw(polylines(scene, positions));
        write_file(path, encoder->encode(image, renderer->inked(), renderer->changed(), *texts));
    };
}

MakeFrame by_libpng(const Scene& scene) {
    const std::shared_ptr<Renderer> renderer = make_renderer(scene);
    return [=, &scene](long, const std::vector<Points>& positions, const std::filesystem::path& path) {
        write_by_libpng(renderer->draw(polylines(scene, positions)), path);
    };
}

std::size_t size_by_libpng(const Image& image) {
    png_image png = libpng_image(image);
    png_alloc_size_t size = 0;
    png_image_write_to_memory(&png, nullptr, &size, 0, image.rgb.data(), 0, nullptr);
    return size;
}

MakeFrame by_cairo(const Scene& scene) {
    cairo_surface_t* const surface =
        cairo_image_surface_create(CAIRO_FORMAT_RGB24, scene.size[0], scene.size[1]);
    const std::shared_ptr<cairo_t> cairo(cairo_create(surface), cairo_destroy);
    cairo_surface_destroy(surface);  // the context keeps it
    return [=, &scene](long, const std::vector<Points>& positions, const std::filesystem::path& path) {
        draw(cairo.get(), scene, positions);
        cairo_surface_write_to_png(cairo_get_target(cairo.get()), path.c_str());
    };
}

Stages stages(const Scene& scene, const Positions& motion, const std::filesystem::path& folder) {
    const int width = scene.size[0];
    const int height = scene.size[1];
    const std::unique_ptr<Renderer> renderer = make_renderer(scene);
    const std::unique_ptr<OffscreenContext> context = make_context();
    const Gl gl = load_gl(*context);
    Framebuffer framebuffer(gl, width, height);
    const RopePainter painter(gl, width, height);
    FrameEncoder encoder(width, height);
    RowTokenizer tokenizer(width);
    std::vector<RowTokens> rows(static_cast<std::size_t>(Tiles(width, height).rows()));
    Texts texts = frame_texts(scene, "");
    const Camera camera{scene.view.center, scene.view.height};
    // OpenGL has done all when a pixel is read.
    const auto finish = [&] { framebuffer.read({0, 0, 1, 1}); };

    const auto frames = static_cast<long>(motion.size());
    Stages times;
    const auto make_frame = [&](long frame) {
        const std::vector<Polyline> lines = polylines(scene, motion.at(frame));
        set_frame(texts, frame);
        std::vector<std::uint8_t> file;
        measure(times.whole, [&] {
            const Image& drawn = renderer->draw(polylines(scene, motion.at(frame)));
            file = encoder.encode(drawn, renderer->inked(), renderer->changed(), texts);
            write_file(folder / ("whole" + frame_name(frame, frames)), file);
        });
        context->make_current();
        for (std::size_t first = 0; first < lines.size(); first += Framebuffer::channels) {
            std::vector<Capsule> capsules;
            Tiles covered(width, height);
            for (std::size_t i = first; i < std::min(lines.size(), first + Framebuffer::channels); ++i)
                append_capsules(lines[i], i - first, camera, width, height, capsules, covered);
            const std::vector<PixelBox> boxes = covered.runs();
            measure(times.clearing, [&] {
                framebuffer.clear(boxes);
                finish();
            });
            measure(times.drawing, [&] {
                painter.paint(capsules);
                finish();
            });
            measure(times.reading, [&] {
                for (const PixelBox& box : boxes) framebuffer.read(box);
            });
        }
        const Image& image = renderer->draw(lines);
        measure(times.filtering, [&] {
            for (int row = 0; row < renderer->inked().rows(); ++row)
                if (rows[static_cast<std::size_t>(row)].ends.empty() ||
                    renderer->changed().any_in_rows(std::max(row - 1, 0), row))
                    tokenizer.tokenize(image, renderer->inked(), row, rows[static_cast<std::size_t>(row)]);
        });
        measure(times.compressing,
                [&] { encoder.encode(image, renderer->inked(), Tiles(width, height), texts); });
        measure(times.writing, [&] { write_file(folder / ("alone" + frame_name(frame, frames)), file); });
    };
    make_frame(0);
    times = {};
    for (long frame = 1; frame < frames; ++frame) make_frame(frame);
    for (double* time : {&times.clearing, &times.drawing, &times.reading, &times.filtering,
                         &times.compressing, &times.writing, &times.whole})
        *time /= static_cast<double>(frames - 1);
    return times;
}

}  // namespace ropesim
