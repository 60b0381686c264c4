#include "diff/accept.h"

#include "clip/file.h"
#include "diff/summary.h"
#include "image/png.h"
#include "scene/words.h"

#include <stdexcept>

namespace ropesim {
namespace {

bool can_be_read(const std::vector<std::uint8_t>& bytes) {
    try {
        decode_png(bytes, "");
        return true;
    } catch (const std::runtime_error&) {
        return false;
    }
}

void accept_frame(const Comparison& comparison, const FrameComparison& frame, Accepted& accepted) {
    const std::string name = one_line(frame.name);
    if (frame.verdict == Verdict::missing) {
        accepted.left.push_back(name + ": only in EXPECTED; delete it there if it is to go");
        return;
    }
    const std::filesystem::path actual = actual_path(comparison, frame);
    const std::vector<std::uint8_t> bytes = read_regular_file(actual);
    if (!can_be_read(bytes)) {
        accepted.left.push_back(name + ": ACTUAL's is no whole PNG");
        return;
    }
    write_file(expected_path(comparison, frame), bytes);
    accepted.done.push_back(name + (frame.verdict == Verdict::extra ? ": added" : ": replaced"));
}

}  // namespace

Accepted accept(const Comparison& comparison) {
    Accepted accepted;
    for (const FrameComparison* frame : failures(comparison)) accept_frame(comparison, *frame, accepted);
    return accepted;
}

}  // namespace ropesim
