#pragma once

#include "clip/frames.h"
#include "scene/scene.h"
#include "simulation/rope.h"

#include <memory>
#include <string>
#include <vector>

namespace ropesim {

// Positions on their way into a file, frame by frame, ascending; the file appears when it is finished. What
// it is made of is what `parse_positions` reads.
class PositionsWriter {
  public:
    virtual ~PositionsWriter() = default;

    // One element per rope of the scene, masses×2 in world units; no rows from where a rope has diverged on.
    virtual void add(long frame, const std::vector<Points>& positions) = 0;
    virtual void finish() = 0;
};

// As NumPy's format where the name ends in .npy, else as CSV; "-" is CSV to standard output. Looks at the
// scene, which must outlive it. Throws std::runtime_error where the file cannot be written, or where it is
// a .npy file, which holds frames from 0 on, and these frames are others.
std::unique_ptr<PositionsWriter> make_positions_writer(const std::string& file, const Scene& scene,
                                                       const FrameList& frames);

// The header of an array of frames × nodes × 2 doubles in NumPy's format 1.0; always as long as this.
inline constexpr std::size_t npy_header_size = 128;
std::string npy_header(long frames, long nodes);

}  // namespace ropesim
