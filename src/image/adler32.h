#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace ropesim {

// The checksum of zlib streams (RFC 1950, section 8.2): a = 1 + sum of the bytes, b = sum of all values of a,
// modulo 65521.
class Adler32 {
  public:
    void add(std::span<const std::uint8_t> bytes);
    void add_zeros(std::size_t count);
    void add(const Adler32& of_what_follows);

    std::uint32_t value() const { return value_; }

  private:
    std::uint32_t value_ = 1;
    std::size_t size_ = 0;
};

}  // namespace ropesim
