#pragma once

#include "compare/parting.h"
#include "render/renderer.h"
#include "simulation/rope.h"

#include <memory>
#include <span>
#include <vector>

namespace ropesim {

enum class Layout {
    overlay,       // all in one picture, a thin line between a mass of the first run and of another where
                   // they are more than a pixel apart
    side_by_side,  // a panel for each run
    difference,    // a panel for each run but the first: what it draws where the first does not, and back
};

// Draws frames of a compared scene. In the corner stand the runs with their steps, how far each was from the
// first up to this frame, and a graph of that over the clip's time.
class ComparisonPainter {
  public:
    // Looks at both, which must outlive it. Throws as Renderer does.
    ComparisonPainter(const Scene& scene, const Parting& parting, Layout layout);

    // `positions` are those of all runs; without rows where one has diverged.
    Image draw(long frame, const std::vector<Points>& positions);

    // As Renderer's.
    std::string description() const { return renderer_.description(); }

  private:
    Image corner(long frame, std::span<const std::size_t> runs) const;
    Image panel(long frame, const std::vector<Points>& positions, std::size_t run);
    Color color(std::size_t run) const;
    std::string distance_up_to(std::size_t run, long frame) const;

    const Scene& scene_;
    const Parting& parting_;
    Layout layout_;
    double scale_;       // pixels at the graph's top
    Renderer renderer_;  // of ropes, without words
};

// Frames next to each other as one figure, three in a row, each as an overlay on a picture of a smaller size.
// `positions` are those of the frames.
Image strip(const Scene& scene, const Parting& parting, const std::vector<long>& frames,
            const std::vector<std::vector<Points>>& positions);

}  // namespace ropesim
