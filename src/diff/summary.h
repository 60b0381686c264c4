#pragma once

#include "diff/compare.h"

#include <string>
#include <string_view>
#include <vector>

namespace ropesim {

// Frames by their numbers, neighbours as one: "12 to 119", "0, 7, 20 to 22". Frames without a number are
// named. After `most` of them: "and 5 more".
std::string ranges(const std::vector<const FrameComparison*>& frames, std::size_t most = 8);

// The frames that do not pass, in their order.
std::vector<const FrameComparison*> failures(const Comparison& comparison);

// What was found of one frame, without its name: "differs: 214 of 1188 drawn pixels by more than 2, ...".
std::string finding(const Comparison& comparison, const FrameComparison& frame);

// One line: how many frames differ, which, which is the first; or that all are the same, and in what sense.
std::string headline(const Comparison& comparison);

// One line per frame that does not pass, at most `most` of them, then ranges of the others.
std::string frame_lines(const Comparison& comparison, std::size_t most = 20);

}  // namespace ropesim
