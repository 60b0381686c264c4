#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace ropesim {

// What zlib unpacks from a bare deflate stream of so many bytes; nothing where it refuses it or has bytes
// left.
std::vector<std::uint8_t> unpacked(const std::vector<std::uint8_t>& stream, std::size_t size);

}  // namespace ropesim
