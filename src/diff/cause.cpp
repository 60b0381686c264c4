#include "diff/cause.h"

#include "clip/run.h"
#include "diff/predictable.h"
#include "diff/shift.h"
#include "diff/side.h"
#include "diff/summary.h"
#include "scene/words.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <stdexcept>

namespace ropesim {
namespace {

using Frames = std::vector<const FrameComparison*>;

// More would keep a user waiting: about ten seconds by the cheapest method.
constexpr double most_mass_steps = 2e9;

Frames with_verdict(const Comparison& comparison, Verdict verdict) {
    Frames frames;
    for (const FrameComparison& frame : comparison.frames)
        if (frame.verdict == verdict) frames.push_back(&frame);
    return frames;
}

void add(Cause& cause, const char* kind, const std::string& sentence) {
    if (std::ranges::find(cause.kinds, kind) == cause.kinds.end()) cause.kinds.push_back(kind);
    cause.sentences.push_back(one_line(sentence));
}

std::string of_frames(const Frames& frames) {
    return (frames.size() == 1 ? "frame " : "frames ") + ranges(frames);
}

void add_shift(const Comparison& comparison, Cause& cause) {
    const long late = shift(comparison);
    if (late == 0) return;
    const std::string count = std::to_string(std::abs(late)) + (std::abs(late) == 1 ? " frame" : " frames");
    add(cause, "shift",
        "ACTUAL is " + count + (late > 0 ? " late" : " early") + ": what differs is what EXPECTED shows " +
            count + (late > 0 ? " before" : " after"));
}

void add_keys(Cause& cause) {
    constexpr std::size_t most = 6;
    if (cause.keys.empty()) return;
    std::string text = "the scenes differ: ";
    for (std::size_t i = 0; i < std::min(most, cause.keys.size()); ++i)
        text += (i == 0 ? "" : "; ") + to_string(cause.keys[i]);
    if (cause.keys.size() > most) text += "; and " + std::to_string(cause.keys.size() - most) + " more keys";
    add(cause, "scene", text);
}

double mass_steps(const Scene& scene) {
    double steps = 0.0;
    for (const SceneRope& rope : scene.ropes)
        steps += static_cast<double>(rope.nodes) * steps_per_frame(scene, rope);
    return steps * scene.frames;
}

bool can_simulate(const Side& side) {
    if (!side.scene || side.drawn_from_positions) return false;
    const Scene& scene = *side.scene;
    const bool is_to_be_planned =
        std::ranges::find(scene.ropes, auto_method, &SceneRope::method) != scene.ropes.end();
    return !is_to_be_planned && mass_steps(scene) <= most_mass_steps &&
           static_cast<double>(masses(scene)) * scene.frames <= most_kept;
}

Positions simulated(const Scene& scene) {
    std::vector<long> frames(static_cast<std::size_t>(scene.frames));
    for (std::size_t i = 0; i < frames.size(); ++i) frames[i] = static_cast<long>(i);
    return positions(simulate(scene, runs(scene)), frames);
}

// Positions beside the frames, else of the scene, simulated again; simulating both sides tells something
// only where their scenes differ.
bool find_positions(Side& expected, Side& actual, bool scenes_differ) {
    const bool one_is_given = expected.positions || actual.positions;
    for (Side* side : {&expected, &actual}) {
        if (side->positions) continue;
        if (!(scenes_differ || one_is_given) || !can_simulate(*side)) return false;
        side->positions = simulated(*side->scene);
    }
    return true;
}

// Whether the masses' way may explain how much a pixel changed. Coverage is 1 within a line and falls to 0
// over one pixel, so that a channel changes by at most 255 per pixel of way for each rope there, and by
// rounding.
bool explains(double distance, std::size_t ropes, const PixelDifference& difference) {
    return difference.largest <= 255.0 * distance * static_cast<double>(ropes) + 1.0;
}

void name_frames(const Comparison& comparison, std::size_t ropes, Cause& cause) {
    for (const FrameComparison& frame : comparison.frames) {
        const auto found = cause.motion.distance.find(frame.number);
        if (frame.verdict != Verdict::different || found == cause.motion.distance.end()) continue;
        const double distance = found->second;
        cause.frames[frame.name] = explains(distance, ropes, frame.difference) ? "motion"
                                   : distance == 0.0                           ? "drawing"
                                                                               : "motion and drawing";
    }
}

Frames frames_drawn_otherwise(const Comparison& comparison, const Cause& cause) {
    Frames frames;
    for (const FrameComparison& frame : comparison.frames) {
        const auto kind = cause.frames.find(frame.name);
        if (kind != cause.frames.end() && kind->second != "motion") frames.push_back(&frame);
    }
    return frames;
}

// Words in the corner that differ, too.
std::string words_text(const Cause& cause) {
    for (const KeyDifference& each : cause.keys)
        for (const std::string_view key : {"title", "clip: steps_per_frame", "clip: words"})
            if (each.key == key) return "; the words in the corner are others, too";
    return "";
}

void add_motion(const Comparison& comparison, const Scene& scene, Cause& cause) {
    name_frames(comparison, scene.ropes.size(), cause);
    for (const std::string& rope : cause.motion.apart)
        add(cause, "motion", "rope '" + rope + "' has other nodes, or is there or diverges on one side only");
    if (cause.motion.first)
        add(cause, "motion",
            "the motion moved: first " + to_string(*cause.motion.first) + "; farthest " +
                to_string(*cause.motion.farthest));
    const Frames drawn = frames_drawn_otherwise(comparison, cause);
    if (drawn.empty()) return;
    if (cause.motion.first)
        add(cause, "drawing",
            "the drawing changed in " + of_frames(drawn) + ", by more than the motion explains" +
                words_text(cause));
    else
        add(cause, "drawing",
            "the drawing changed in " + of_frames(drawn) +
                (cause.motion.apart.empty() ? "; every mass is where it was, to the last bit" : "") +
                words_text(cause));
}

void add_chaos(const Scene& scene, Cause& cause) {
    cause.unpredictable = first_unpredictable_frame(scene);
    if (!cause.unpredictable ||
        cause.motion.distance.upper_bound(*cause.unpredictable - 1) == cause.motion.distance.end())
        return;
    add(cause, "chaos",
        "from frame " + std::to_string(*cause.unpredictable) +
            " on a rounding at the start has grown beyond a millionth of a pixel: that masses are elsewhere "
            "there "
            "says nothing, and fails nothing");
}

void add_scenes(const Comparison& comparison, Cause& cause) {
    Side expected = side(comparison, Which::expected);
    Side actual = side(comparison, Which::actual);
    for (const Side* each : {&expected, &actual})
        if (!each->problem.empty()) add(cause, "unknown", each->problem);
    if (!expected.scene && !actual.scene) return;
    // Of positions without a scene beside them, that of the other side tells the ropes.
    if (!expected.scene) {
        expected.scene = actual.scene;
        read_positions(comparison, Which::expected, expected);
    }
    if (!actual.scene) {
        actual.scene = expected.scene;
        read_positions(comparison, Which::actual, actual);
    }
    cause.keys = key_differences(*expected.scene, *actual.scene);
    add_keys(cause);
    if (!find_positions(expected, actual, !cause.keys.empty())) {
        if (cause.kinds.empty() || !cause.keys.empty())
            add(cause, "unknown",
                std::string(cause.keys.empty() ? "the scenes are the same; " : "") +
                    "positions.csv beside the frames of both would tell whether the motion or the drawing "
                    "changed");
        return;
    }
    cause.motion = motion_difference(*expected.scene, *expected.positions, *actual.scene, *actual.positions);
    add_motion(comparison, *expected.scene, cause);
    if (cause.motion.first && cause.keys.empty() && can_simulate(expected)) add_chaos(*expected.scene, cause);
}

// What the pixels alone tell.
void add_pixels(const Frames& different, Cause& cause) {
    PixelDifference sum;
    for (const FrameComparison* frame : different) {
        sum.over += frame->difference.over;
        sum.gone += frame->difference.gone;
        sum.added += frame->difference.added;
    }
    const std::string others = std::to_string(sum.over - sum.gone - sum.added) + " of another colour";
    const std::string where = " in " + of_frames(different) + ": ";
    if (sum.gone > 0 && sum.added == 0)
        add(cause, "less",
            "something is not drawn" + where + std::to_string(sum.gone) + " pixels gone, none new, " +
                others);
    if (sum.added > 0 && sum.gone == 0)
        add(cause, "more",
            "something is drawn in addition" + where + std::to_string(sum.added) +
                " pixels new, none gone, " + others);
    if (sum.added == 0 && sum.gone == 0)
        add(cause, "color", "the same shapes in other colours" + where + others + ", none new, none gone");
}

void add_files(const Comparison& comparison, Cause& cause) {
    struct Row {
        Verdict verdict;
        const char* kind;
        const char* what;
    };
    constexpr std::array<Row, 4> rows{{{Verdict::missing, "missing", "missing in ACTUAL: "},
                                       {Verdict::extra, "extra", "only in ACTUAL: "},
                                       {Verdict::other_size, "size", "of another size: "},
                                       {Verdict::unreadable, "unreadable", "unreadable: "}}};
    for (const Row& row : rows) {
        const Frames frames = with_verdict(comparison, row.verdict);
        if (!frames.empty()) add(cause, row.kind, row.what + of_frames(frames));
    }
}

// Frames whose pixels are the same, and whether they say of themselves that they show another scene.
void add_same_pixels(const Comparison& comparison, Cause& cause) {
    Frames same = with_verdict(comparison, Verdict::same_pixels);
    const auto others = std::ranges::stable_partition(same, [](const FrameComparison* frame) {
        return frame->expected.scene == frame->actual.scene || frame->expected.scene.empty() ||
               frame->actual.scene.empty();
    });
    const Frames of_other_scenes(others.begin(), others.end());
    same.erase(others.begin(), others.end());
    if (!same.empty())
        add(cause, "file-format", "only the file format changed, not a pixel: " + of_frames(same));
    if (!of_other_scenes.empty() && cause.keys.empty())
        add(cause, "scene", "of another scene, but the same pixels: " + of_frames(of_other_scenes));
}

}  // namespace

void excuse_chaos(const Cause& cause, Comparison& comparison) {
    if (!cause.unpredictable) return;
    for (FrameComparison& frame : comparison.frames) {
        const auto kind = cause.frames.find(frame.name);
        if (frame.number >= *cause.unpredictable && kind != cause.frames.end() && kind->second == "motion")
            frame.verdict = Verdict::chaos;
    }
}

Cause cause(const Comparison& comparison) {
    Cause cause;
    const Frames different = with_verdict(comparison, Verdict::different);
    if (!different.empty()) {
        add_shift(comparison, cause);
        add_scenes(comparison, cause);
        add_pixels(different, cause);
    }
    add_files(comparison, cause);
    add_same_pixels(comparison, cause);
    if (cause.sentences.empty() && !different.empty())
        add(cause, "unknown", "the frames carry no scene, so that motion and drawing cannot be told apart");
    return cause;
}

}  // namespace ropesim
