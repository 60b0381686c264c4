#pragma once

#include "clip/frames.h"
#include "clip/positions.h"
#include "scene/scene.h"
#include "simulation/simulate.h"

#include <string>
#include <vector>

namespace ropesim {

// A rope of a scene, with what moves it.
struct Run {
    const SceneRope* description;  // of the scene it was made from
    const Method* method;
    Rope rope;
    Stepping stepping;
};

// One run per rope, in the scene's order; they point into the scene.
std::vector<Run> runs(const Scene& scene);

// Sentences for ropes whose steps are not stable: what is wrong and how many steps per frame are right.
std::vector<std::string> stability_warnings(const Scene& scene, const std::vector<Run>& runs);

// Why a rope diverged in that frame.
std::string divergence(const Scene& scene, const Run& run, long frame);

// The trajectories of the runs over all frames of the scene, and of them the frames that are asked for: all
// in memory, where a Simulation would hold one frame.
std::vector<Trajectory> simulate(const Scene& scene, const std::vector<Run>& runs);
Positions positions(const std::vector<Trajectory>& trajectories, const FrameList& frames);

}  // namespace ropesim
