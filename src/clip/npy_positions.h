#pragma once

#include "scene/scene.h"
#include "simulation/rope.h"

#include <array>
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
// float64, as repeated numpy.load calls on the open file read them); frames from 0 on. Keeps none of them.
class NpyPositions {
  public:
    // Puts what stands at an offset of the file into the bytes.
    using ReadAt = std::function<void(std::uint64_t offset, std::span<std::uint8_t> bytes)>;

    // Reads all once. Throws std::runtime_error, "<name>: what was found, what was expected", where the file
    // does not fit the scene's ropes or a number is not finite.
    NpyPositions(const Scene& scene, std::uint64_t size, ReadAt read_at, std::string_view name);

    long frames() const;

    // Of each rope of the scene; one whose array ends before this frame has no rows.
    std::vector<Points> at(long frame) const;

  private:
    struct Array {
        long frames;
        long nodes;
        std::uint64_t begin;  // of its numbers

        std::uint64_t frame_bytes() const;
        std::uint64_t frame_begin(long frame) const;
    };

    // Of the array that begins there; puts where its numbers do in its place.
    std::array<long, 3> read_shape(std::uint64_t& begin, std::uint64_t size, const std::string& where) const;
    void check_finite(const Array& array, const std::string& where) const;

    ReadAt read_at_;
    std::vector<Array> arrays_;  // of each rope
};

}  // namespace ropesim
