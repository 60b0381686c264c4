#pragma once

#include "image/image.h"
#include "scene/scene.h"
#include "study/failures.h"

#include <vector>

namespace ropesim {

// A row for each method: three moments of the run at the fewest steps that hold, then the same of the run
// with a step less, each over the truth in gray. The scene's view and background.
Image failure_sheet(const Scene& scene, const SceneRope& rope, const Truth& truth,
                    const std::vector<Failure>& failures);

}  // namespace ropesim
