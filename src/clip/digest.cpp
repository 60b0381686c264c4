#include "clip/digest.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <vector>

namespace ropesim {
namespace {

std::string digits(XXH128_hash_t hash) {
    std::array<char, 33> digits;
    std::snprintf(digits.data(), digits.size(), "%016llx%016llx",
                  static_cast<unsigned long long>(hash.high64), static_cast<unsigned long long>(hash.low64));
    return digits.data();
}

}  // namespace

std::string digest(std::string_view bytes) {
    return digits(XXH3_128bits(bytes.data(), bytes.size()));
}

std::string digest(const OpenFile& file) {
    constexpr std::uint64_t at_once = std::uint64_t{1} << 20;
    const std::uint64_t size = file.size().value_or(0);
    XXH3_state_t state;
    XXH3_128bits_reset(&state);
    std::vector<std::uint8_t> bytes;
    for (std::uint64_t offset = 0; offset < size; offset += bytes.size()) {
        bytes.resize(std::min(size - offset, at_once));
        file.read_at(offset, bytes);
        XXH3_128bits_update(&state, bytes.data(), bytes.size());
    }
    return digits(XXH3_128bits_digest(&state));
}

}  // namespace ropesim
