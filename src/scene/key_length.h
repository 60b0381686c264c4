#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace ropesim {

// Keys of more parts, such as a.b.c, are refused: toml++ 3.3 keeps each part as a table in the one before,
// and takes them apart by recursion, which ends in a stack overflow.
inline constexpr std::size_t most_key_parts = 100;

struct Place {
    std::size_t line;
    std::size_t column;
};

// Where TOML has more than that many parts between dots in a row: the last of them.
std::optional<Place> overlong_key(std::string_view toml);

}  // namespace ropesim
