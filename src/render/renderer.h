#pragma once

#include "image/image.h"
#include "image/tiles.h"

#include <Eigen/Core>

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace ropesim {

// What the picture shows: world coordinates x (right) and y (up).
struct Camera {
    Eigen::Array2d center = {0.0, 0.0};
    double height = 1.0;  // of the picture in world units
};

// A chain of masses (round points) joined by links (lines with round ends), drawn as one shape.
struct Polyline {
    Eigen::ArrayX2d points;  // world units
    Color color = {255, 255, 255};
    double line_width = 4.0;  // pixels; 0 draws no links
    double point_size = 8.0;  // the masses' diameter in pixels; 0 draws none
};

// A line of words in the picture's top left corner; lines stand one below the other.
struct Words {
    std::string text;  // UTF-8
    Color color = {255, 255, 255};
};

// Draws pictures of one size, off screen. Owns an OpenGL context, so it stays in the thread that made it;
// several may live side by side in one thread.
//
// A rope is the union of its links and masses: a pixel whose centre lies at distance d from the nearest of
// them, of that one's radius r, is covered by clamp(r + 1/2 - d, 0, 1), which OpenGL computes; its colour is
// mixed with what was there by that part. Same input, same bytes, whatever the way to make the context, the
// number of threads and the processor.
class Renderer {
  public:
    // What is the same in every frame: the size, the background, the words. Throws std::runtime_error
    // where no context can be made (the message names what was tried and what to install), a shader does
    // not compile (with its log), or the picture is empty or larger than the driver allows (with the
    // limit). Words are cut with an ellipsis where they are wider than the picture.
    // The environment variable ROPESIM_CONTEXT, "osmesa" or "egl", picks one way to make a context.
    Renderer(int width, int height, const Camera& camera, Color background, std::span<const Words> words);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    // The picture of these polylines, later ones over earlier ones, words over all. Coordinates may be
    // any numbers, however far outside; a polyline with a non-finite coordinate is drawn up to there.
    // Throws std::runtime_error where the driver fails. The image is valid until the next call.
    const Image& draw(std::span<const Polyline> polylines);

    // The tiles of that picture outside which all is background, and those outside which it is the picture
    // before it (at first: the background).
    const Tiles& inked() const;
    const Tiles& changed() const;

    // For reports, such as "OSMesa 22.3.6, llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 3.3".
    std::string description() const;

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace ropesim
