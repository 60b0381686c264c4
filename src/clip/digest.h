#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace ropesim {

// 128 bits of bytes as 32 hexadecimal digits (XXH3), of bytes that come in parts.
class Digest {
  public:
    Digest();
    ~Digest();

    // Behind what was added before.
    void add(std::span<const std::uint8_t> bytes);

    // Of all that was added.
    std::string text() const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

// The same of bytes that are there.
std::string digest(std::string_view bytes);

}  // namespace ropesim
