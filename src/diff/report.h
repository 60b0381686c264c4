#pragma once

#include "diff/cause.h"

#include <string>

namespace ropesim {

// At most so many frames that differ, and so many bytes of their files, have their pictures in a report:
// the first half of them one after the other, the rest evenly spaced over those that are left.
inline constexpr std::size_t most_pictured_frames = 120;
inline constexpr std::size_t most_pictured_bytes = std::size_t{48} << 20;

// The comparison as one HTML file that needs no network: verdict, causes, a plot over all frames, and the
// frames that differ, expected, actual and difference, with a slider, blinking and a zoom on what changed.
std::string to_html(const Comparison& comparison, const Cause& cause);

// Which of `count` frames are pictured: indices, sorted, at most `most`.
std::vector<std::size_t> pictured(std::size_t count, std::size_t most);

// RFC 4648, section 4.
std::string base64(std::string_view bytes);

}  // namespace ropesim
