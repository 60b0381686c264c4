// Makes the pictures and positions of every golden case anew, the frames that it holds or four of them, and
// the golden comparisons.

#include "golden/golden_case.h"

#include "clip/frames.h"

#include <cstdio>
#include <exception>

namespace {

using namespace ropesim;

FrameList frames_of(const std::string& name, const Scene& scene) {
    const FrameList frames = frames_in(golden_folder() / name);
    if (!frames.empty()) return frames;
    const long last = scene.frames - 1;
    return {0, last / 3, 2 * last / 3, last};
}

}  // namespace

int main() {
    try {
        for (const std::string& name : golden_cases()) {
            const Scene scene = scene_of_case(name);
            store(made(name, scene, frames_of(name, scene)), golden_folder() / name);
            std::printf("golden/%s\n", name.c_str());
        }
        for (const std::string& layout : comparison_layouts()) {
            store_comparison(layout, made_comparison(layout));
            std::printf("golden/comparisons/%s.png\n", layout.c_str());
        }
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "update_golden: %s\n", error.what());
        return 1;
    }
}
