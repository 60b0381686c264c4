#include "image/adler32.h"

#include <zlib.h>

namespace ropesim {

void Adler32::add(std::span<const std::uint8_t> bytes) {
    value_ = static_cast<std::uint32_t>(adler32_z(value_, bytes.data(), bytes.size()));
    size_ += bytes.size();
}

// A zero leaves a as it is, so that n of them add n a to b.
void Adler32::add_zeros(std::size_t count) {
    const std::uint64_t a = value_ & 0xffffU;
    const std::uint64_t b = value_ >> 16;
    value_ = static_cast<std::uint32_t>((b + count % 65521 * a) % 65521 << 16 | a);
    size_ += count;
}

void Adler32::add(const Adler32& of_what_follows) {
    value_ = static_cast<std::uint32_t>(
        adler32_combine(value_, of_what_follows.value_, static_cast<z_off_t>(of_what_follows.size_)));
    size_ += of_what_follows.size_;
}

}  // namespace ropesim
