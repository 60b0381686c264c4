#include "diff/summary.h"

#include "scene/words.h"

#include <algorithm>

namespace ropesim {
namespace {

std::string counted(std::size_t count, const char* what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string size(const std::array<int, 2>& size) {
    return std::to_string(size[0]) + "x" + std::to_string(size[1]);
}

std::string span(int first, int last, const char* what) {
    if (first == last) return std::string(what) + " " + std::to_string(first);
    return std::string(what) + "s " + std::to_string(first) + " to " + std::to_string(last);
}

std::string differing_pixels(const PixelDifference& difference, const Tolerance& tolerance) {
    const Region& region = difference.region;
    return std::to_string(difference.over) + " of " + std::to_string(difference.drawn) +
           " drawn pixels by more than " + std::to_string(tolerance.channel) + " (" +
           std::to_string(difference.gone) + " gone, " + std::to_string(difference.added) + " new, " +
           std::to_string(difference.over - difference.gone - difference.added) + " changed), most by " +
           std::to_string(difference.largest) + " of 255; " + span(region.left, region.right, "column") +
           ", " + span(region.top, region.bottom, "row");
}

std::string label(const FrameComparison& frame) {
    return frame.number < 0 ? frame.name : std::to_string(frame.number);
}

bool are_neighbours(const FrameComparison& a, const FrameComparison& b) {
    return a.number >= 0 && b.number == a.number + 1;
}

long count(const Comparison& comparison, Verdict verdict) {
    return std::ranges::count(comparison.frames, verdict, &FrameComparison::verdict);
}

std::string all_pass(const Comparison& comparison) {
    std::string text = "same: " + counted(comparison.frames.size(), "frame");
    if (const long others = count(comparison, Verdict::same_pixels); others > 0)
        text += ", " + std::to_string(others) + " of them in other bytes with the same pixels";
    if (const long within = count(comparison, Verdict::within); within > 0)
        text += ", " + std::to_string(within) + " of them only within the tolerance";
    if (const long chaos = count(comparison, Verdict::chaos); chaos > 0)
        text += ", but for " + std::to_string(chaos) + " that nobody can predict";
    return text;
}

}  // namespace

std::string ranges(const std::vector<const FrameComparison*>& frames, std::size_t most) {
    std::string text;
    std::size_t shown = 0;
    for (std::size_t i = 0; i < frames.size(); ++shown) {
        if (shown == most) return text + " and " + std::to_string(frames.size() - i) + " more";
        std::size_t end = i + 1;
        while (end < frames.size() && are_neighbours(*frames[end - 1], *frames[end])) ++end;
        text += (text.empty() ? "" : ", ") + label(*frames[i]);
        if (end > i + 1) text += (end > i + 2 ? " to " : ", ") + label(*frames[end - 1]);
        i = end;
    }
    return one_line(text);
}

std::vector<const FrameComparison*> failures(const Comparison& comparison) {
    std::vector<const FrameComparison*> failed;
    for (const FrameComparison& frame : comparison.frames)
        if (!passes(frame.verdict)) failed.push_back(&frame);
    return failed;
}

std::string finding(const Comparison& comparison, const FrameComparison& frame) {
    switch (frame.verdict) {
        case Verdict::same_bytes:
            return "same";
        case Verdict::same_pixels:
            return "same pixels in other bytes";
        case Verdict::within:
            return "within the tolerance: " +
                   counted(static_cast<std::size_t>(frame.difference.changed), "pixel") +
                   " changed, most by " + std::to_string(frame.difference.largest) + " of 255";
        case Verdict::chaos:
            return "unpredictable: " + differing_pixels(frame.difference, comparison.tolerance);
        case Verdict::different:
            return "differs: " + differing_pixels(frame.difference, comparison.tolerance);
        case Verdict::other_size:
            return "other size: found " + size(frame.actual_size) + " pixels, expected " +
                   size(frame.expected_size);
        case Verdict::missing:
            return "missing: only in EXPECTED";
        case Verdict::extra:
            return "extra: only in ACTUAL";
        case Verdict::unreadable:
            return "unreadable: " + frame.problem;
    }
    return "";
}

std::string headline(const Comparison& comparison) {
    const std::vector<const FrameComparison*> failed = failures(comparison);
    if (failed.empty()) return all_pass(comparison);
    if (!comparison.folders) return "differ: " + finding(comparison, *failed.front());
    std::string text = std::to_string(failed.size()) + " of " + counted(comparison.frames.size(), "frame") +
                       (failed.size() == 1 ? " differs: " : " differ: ") + ranges(failed);
    if (failed.size() > 1) text += "; first " + one_line(failed.front()->name);
    return text;
}

std::string frame_lines(const Comparison& comparison, std::size_t most) {
    const std::vector<const FrameComparison*> failed = failures(comparison);
    const std::size_t shown = std::min(most, failed.size());
    std::string text;
    for (std::size_t i = 0; i < shown; ++i)
        text += one_line(failed[i]->name + ": " + finding(comparison, *failed[i])) + "\n";
    if (shown == failed.size()) return text;
    const std::vector<const FrameComparison*> rest(failed.begin() + static_cast<std::ptrdiff_t>(shown),
                                                   failed.end());
    return text + "and " + counted(rest.size(), "more frame") + ": " + ranges(rest) + "\n";
}

}  // namespace ropesim
