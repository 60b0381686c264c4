// What a frame of the seed's clip costs at 1280 x 720 on one core, in four ways that take turns, so that a
// busy machine slows all alike: ours; our pictures by libpng's defaults; cairo's draw and write; and for
// what it is worth, ours without the disk. Prints the median over the rounds and the ratio to cairo's.

#include "clip/file.h"
#include "clip/frames.h"
#include "clip/manifest.h"
#include "clip/picture.h"
#include "clip/run.h"
#include "image/frame_encoder.h"

#include <cairo.h>
#include <png.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <stdexcept>

namespace {

using namespace ropesim;

constexpr int rounds = 9;
constexpr long frames = 40;  // in each round

// The same picture as ours, as a careful user of cairo draws it: round joins, then round points.
void draw_by_cairo(cairo_t* cairo, const Scene& scene, const std::vector<Points>& ropes) {
    const auto channel = [](std::uint8_t byte) { return byte / 255.0; };
    const double scale = scene.size[1] / scene.view.height;
    const auto column = [&](double x) { return scene.size[0] / 2.0 + (x - scene.view.center[0]) * scale; };
    const auto row = [&](double y) { return scene.size[1] / 2.0 - (y - scene.view.center[1]) * scale; };
    const auto colour = [&](const Color& color) {
        cairo_set_source_rgb(cairo, channel(color[0]), channel(color[1]), channel(color[2]));
    };
    colour(scene.background);
    cairo_paint(cairo);
    for (std::size_t i = 0; i < ropes.size(); ++i) {
        const SceneRope& rope = scene.ropes[i];
        colour(rope.color);
        cairo_set_line_width(cairo, rope.line_width);
        cairo_set_line_join(cairo, CAIRO_LINE_JOIN_ROUND);
        for (Eigen::Index mass = 0; mass < ropes[i].rows(); ++mass)
            cairo_line_to(cairo, column(ropes[i](mass, 0)), row(ropes[i](mass, 1)));
        cairo_stroke(cairo);
        for (Eigen::Index mass = 0; mass < ropes[i].rows(); ++mass) {
            cairo_arc(cairo, column(ropes[i](mass, 0)), row(ropes[i](mass, 1)), rope.point_size / 2, 0,
                      6.2831853);
            cairo_fill(cairo);
        }
    }
    colour({255, 255, 255});
    cairo_select_font_face(cairo, "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo, 18);
    cairo_move_to(cairo, 10, 24);
    cairo_show_text(cairo, scene.title.c_str());
    cairo_move_to(cairo, 10, 48);
    cairo_show_text(cairo, ("Steps per frame: " + std::to_string(scene.steps_per_frame)).c_str());
}

void write_by_libpng(const Image& image, const std::filesystem::path& path) {
    png_image png{};
    png.version = PNG_IMAGE_VERSION;
    png.width = static_cast<png_uint_32>(image.width);
    png.height = static_cast<png_uint_32>(image.height);
    png.format = PNG_FORMAT_RGB;
    if (png_image_write_to_file(&png, path.c_str(), 0, image.rgb.data(), 0, nullptr) == 0)
        throw std::runtime_error(png.message);
}

struct Contestant {
    const char* name;
    std::function<void(long frame, const std::filesystem::path& path)> make_frame;
    std::vector<double> milliseconds;  // per frame, one number a round
};

double milliseconds_per_frame(const Contestant& contestant, const std::filesystem::path& folder) {
    const auto start = std::chrono::steady_clock::now();
    for (long frame = 0; frame < frames; ++frame)
        contestant.make_frame(frame, folder / (contestant.name + frame_name(frame, frames)));
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count() /
           static_cast<double>(frames);
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values[values.size() / 2];
}

std::vector<Contestant> contestants(const Scene& scene, const Positions& motion, Renderer& renderer,
                                    cairo_t* cairo) {
    const auto draw = [&](long frame) -> const Image& {
        return renderer.draw(polylines(scene, motion.at(frame)));
    };
    const auto encoder = std::make_shared<FrameEncoder>(scene.size[0], scene.size[1]);
    const auto texts = std::make_shared<Texts>(frame_texts(scene, ""));
    const auto encode = [&renderer, texts, draw, encoder](long frame) {
        set_frame(*texts, frame);
        const Image& image = draw(frame);
        return encoder->encode(image, renderer.inked(), renderer.changed(), *texts);
    };
    return {{"ropesim", [=](long frame, const auto& path) { write_file(path, encode(frame)); }, {}},
            {"ropesim, not written", [=](long frame, const auto&) { encode(frame); }, {}},
            {"ropesim, drawing only", [=](long frame, const auto&) { draw(frame); }, {}},
            {"ropesim, PNG by libpng",
             [=](long frame, const auto& path) { write_by_libpng(draw(frame), path); },
             {}},
            {"cairo",
             [&scene, &motion, cairo](long frame, const auto& path) {
                 draw_by_cairo(cairo, scene, motion.at(frame));
                 cairo_surface_write_to_png(cairo_get_target(cairo), path.c_str());
             },
             {}}};
}

void race(const std::filesystem::path& folder) {
    Scene scene = parse_scene(builtin_scenes().front().toml, "seed");
    scene.size = {1280, 720};
    const Positions motion = positions(simulate(scene, runs(scene)), parse_frames("", scene.frames));
    const auto renderer = make_renderer(scene);
    cairo_surface_t* surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, scene.size[0], scene.size[1]);
    cairo_t* cairo = cairo_create(surface);
    std::vector<Contestant> all_of_them = contestants(scene, motion, *renderer, cairo);
    for (int round = 0; round < rounds; ++round)
        for (Contestant& contestant : all_of_them)
            contestant.milliseconds.push_back(milliseconds_per_frame(contestant, folder));
    cairo_destroy(cairo);
    cairo_surface_destroy(surface);
    const double baseline = median(all_of_them.back().milliseconds);
    std::printf("%-24s %10s %10s %12s\n", "1280 x 720, one core", "ms/frame", "frames/s", "times cairo");
    for (const Contestant& contestant : all_of_them) {
        const double each = median(contestant.milliseconds);
        std::printf("%-24s %10.3f %10.0f %12.1f\n", contestant.name, each, 1000.0 / each, baseline / each);
    }
}

}  // namespace

int main(int count, char** values) {
    const std::filesystem::path folder = count > 1 ? values[1] : std::filesystem::temp_directory_path();
    const std::filesystem::path frames_folder = folder / ("frames-benchmark-" + std::to_string(std::rand()));
    try {
        std::filesystem::create_directories(frames_folder);
        race(frames_folder);
        std::filesystem::remove_all(frames_folder);
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "frames_benchmark: %s\n", error.what());
        return 1;
    }
}
