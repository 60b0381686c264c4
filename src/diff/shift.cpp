#include "diff/shift.h"

#include "clip/file.h"
#include "image/png.h"

#include <optional>
#include <stdexcept>

namespace ropesim {
namespace {

// Whether the picture of ACTUAL's frame is that of EXPECTED's other frame; nothing where there is no other.
std::optional<bool> shows(const Comparison& comparison, std::size_t frame, long other) {
    if (other < 0 || other >= static_cast<long>(comparison.frames.size())) return std::nullopt;
    const FrameComparison& late = comparison.frames[frame];
    const FrameComparison& source = comparison.frames[static_cast<std::size_t>(other)];
    if (source.verdict == Verdict::extra || source.verdict == Verdict::unreadable) return std::nullopt;
    if (!source.expected.pixels.empty()) return source.expected.pixels == late.actual.pixels;
    const auto expected = expected_path(comparison, source);
    const auto actual = actual_path(comparison, late);
    try {
        return decode_png(read_regular_file(expected), expected.string()) ==
               decode_png(read_regular_file(actual), actual.string());
    } catch (const std::runtime_error&) {
        return std::nullopt;
    }
}

bool is_shifted_by(const Comparison& comparison, long frames) {
    bool found = false;
    for (std::size_t i = 0; i < comparison.frames.size(); ++i) {
        if (comparison.frames[i].verdict != Verdict::different) continue;
        const std::optional<bool> same = shows(comparison, i, static_cast<long>(i) - frames);
        if (same && !*same) return false;
        found = found || same;
    }
    return found;
}

}  // namespace

long shift(const Comparison& comparison) {
    for (const long frames : {1, -1, 2, -2, 3, -3})
        if (is_shifted_by(comparison, frames)) return frames;
    return 0;
}

}  // namespace ropesim
