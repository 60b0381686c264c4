#include "clip/digest.h"

#define XXH_INLINE_ALL
#include <xxhash.h>

#include <array>
#include <cstdio>

namespace ropesim {

struct Digest::State {
    XXH3_state_t xxh3;
};

Digest::Digest() : state_(std::make_unique<State>()) {
    XXH3_128bits_reset(&state_->xxh3);
}

Digest::~Digest() = default;

void Digest::add(std::span<const std::uint8_t> bytes) {
    XXH3_128bits_update(&state_->xxh3, bytes.data(), bytes.size());
}

std::string Digest::text() const {
    const XXH128_hash_t hash = XXH3_128bits_digest(&state_->xxh3);
    std::array<char, 33> digits;
    std::snprintf(digits.data(), digits.size(), "%016llx%016llx",
                  static_cast<unsigned long long>(hash.high64), static_cast<unsigned long long>(hash.low64));
    return digits.data();
}

std::string digest(std::string_view bytes) {
    Digest whole;
    whole.add({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
    return whole.text();
}

}  // namespace ropesim
