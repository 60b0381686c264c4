#include "farm/clip_work.h"

#include "clip/run.h"
#include "clip/simulation.h"
#include "study/plan.h"

#include <algorithm>

namespace ropesim {
namespace {

// Evaluations, for each mass, of a frame. A few steps tell what the others take.
double frame_work(const Run& run) {
    constexpr long enough = 8;
    Stepping few = run.stepping;
    few.steps = std::min(enough, few.steps);
    MovingRope rope(run.rope, *run.method, few);
    rope.advance();
    return work(run.rope, *run.method, rope.cost()) * static_cast<double>(run.stepping.steps) /
           static_cast<double>(few.steps);
}

}  // namespace

double ClipWork::simulating_share(long shards) const {
    return simulating / (simulating + drawing / static_cast<double>(shards));
}

ClipWork clip_work(const Scene& scene) {
    const auto frames = static_cast<double>(scene.frames);
    ClipWork work;
    double all_masses = 0.0;
    for (const Run& run : runs(scene)) {
        const auto masses = static_cast<double>(run.rope.mass.size());
        all_masses += masses;
        work.simulating += frames * masses * frame_work(run);
    }
    work.drawing = frames * drawing_work(all_masses);
    work.positions_bytes = frames * all_masses * 2.0 * sizeof(double);
    return work;
}

bool worth_simulating_once(const ClipWork& work, long shards) {
    constexpr double most_bytes = 0x1p34;
    return shards > 1 && work.simulating_share(shards) > 0.5 && work.positions_bytes <= most_bytes;
}

}  // namespace ropesim
