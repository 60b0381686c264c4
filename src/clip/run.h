#pragma once

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

// The trajectories of the runs, over all frames of the scene.
std::vector<Trajectory> simulate(const Scene& scene, const std::vector<Run>& runs);

// Sentences for ropes whose steps are not stable: what is wrong and how many steps per frame are right.
std::vector<std::string> stability_warnings(const Scene& scene, const std::vector<Run>& runs);

// Why a rope diverged, or "" where it did not.
std::string divergence(const Scene& scene, const Run& run, const Trajectory& trajectory);

// CSV of the frames that are asked for: energies, largest stretch and tension of a link, length.
std::string diagnostics_csv(const Scene& scene, const std::vector<Trajectory>& trajectories,
                            const std::vector<long>& frames);

// The frames that are asked for (sorted, each once).
Positions positions(const std::vector<Trajectory>& trajectories, const std::vector<long>& frames);

}  // namespace ropesim
