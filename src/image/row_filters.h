#pragma once

#include "image/image.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace ropesim {

// The filters of Portable Network Graphics, 2nd edition, 2003, section 9.2: a byte less one that is predicted
// from those to its left, above it, and above to its left.
enum class Filter : std::uint8_t { none, sub, up, average, paeth };

// The rows of a picture from `begin` to before `end`, each behind the byte that names its filter: all by one;
// or, where none is named, each by the one that makes it lightest, which is how section 12.8 advises to
// choose.
std::vector<std::uint8_t> filtered_rows(const Image& image, int begin, int end, std::optional<Filter> filter);

}  // namespace ropesim
