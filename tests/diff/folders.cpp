#include "diff/folders.h"

#include "clip/file.h"
#include "clip/frames.h"
#include "image/png.h"

namespace ropesim {

Folders::Folders() {
    for (const char* folder : {"expected", "actual"})
        std::filesystem::create_directory(temporary.path() / folder);
}

void Folders::put(const char* folder, long frame, const Image& image) {
    write_file(temporary.path() / folder / frame_name(frame, 1), encode_png(image, {}));
}

void Folders::put_both(long frame, const Image& image) {
    put("expected", frame, image);
    put("actual", frame, image);
}

void Folders::put_bytes(const char* folder, const std::string& name, std::string_view bytes) {
    write_file(temporary.path() / folder / name, bytes);
}

Comparison Folders::compared(const Tolerance& tolerance) const {
    return compare(temporary.path() / "expected", temporary.path() / "actual", tolerance);
}

std::vector<Verdict> Folders::verdicts(const Tolerance& tolerance) const {
    std::vector<Verdict> result;
    for (const FrameComparison& frame : compared(tolerance).frames) result.push_back(frame.verdict);
    return result;
}

}  // namespace ropesim
