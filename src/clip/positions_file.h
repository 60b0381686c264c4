#pragma once

#include "clip/file.h"
#include "clip/frames.h"
#include "clip/npy_positions.h"
#include "clip/positions.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ropesim {

// A file of positions, as parse_positions reads it. Of one in NumPy's format, which may be long, a frame is
// read when it is asked for; CSV, and what comes through a pipe, is kept.
class PositionsFile {
  public:
    // Reads all once, and throws what parse_positions throws; std::runtime_error, "<path>: why", where it
    // cannot be read, or is to be kept and has more than 4 GiB.
    PositionsFile(const Scene& scene, const std::filesystem::path& path);

    // Of its bytes, as they were then.
    const std::string& digest() const { return digest_; }

    FrameList frames() const;

    // Throws std::runtime_error, "<path>: holds no frame 7", where it has not all of these.
    void check_has(const FrameList& frames) const;

    // Of each rope, masses×2, of a frame that it has; a rope that has no rows has diverged before. Throws
    // std::runtime_error where the file has changed since, or cannot be read any more.
    std::vector<Points> at(long frame) const;

    PositionsFile(const PositionsFile&) = delete;
    PositionsFile& operator=(const PositionsFile&) = delete;

  private:
    OpenFile file_;
    std::string digest_;
    std::optional<NpyPositions> npy_;
    Positions kept_;  // otherwise
};

}  // namespace ropesim
