#pragma once

#include "scene/scene.h"
#include "simulation/rope.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ropesim {

// What a file in NumPy's format begins with.
inline constexpr std::string_view npy_magic = "\x93NUMPY";

// Positions in NumPy's format: one array per rope, one after the other in one file (frames × nodes × 2,
// float64, as repeated numpy.load calls on the open file read them); frames from 0 on. Knows where they are,
// and keeps none.
class NpyPositions {
  public:
    // Puts what stands at an offset of the file into the bytes.
    using ReadAt = std::function<void(std::uint64_t offset, std::span<std::uint8_t> bytes)>;

    // Reads all bytes, once and in their order. Throws std::runtime_error, "<name>: what was found, what was
    // expected", where the file does not fit the scene's ropes or a number is not finite.
    NpyPositions(const Scene& scene, std::uint64_t size, const ReadAt& read_at, std::string_view name);

    long frames() const;

    // Of each rope of the scene; one whose array ends before this frame has no rows.
    std::vector<Points> at(long frame, const ReadAt& read_at) const;

  private:
    struct Array {
        long frames;
        long nodes;
        std::uint64_t begin;  // of its numbers

        std::uint64_t frame_bytes() const;
        std::uint64_t frame_begin(long frame) const;
    };
    class Reader;

    std::vector<Array> arrays_;  // of each rope
};

}  // namespace ropesim
