#pragma once

#include "study/method_error.h"

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace ropesim {

// What a run is worth on the picture.
enum class Quality {
    exact,     // within half a pixel of the truth
    usable,    // within eight pixels, a mass as it is usually drawn
    wrong,     // farther off, but bounded
    diverged,  // did not reach the end
};
Quality quality(double worst_pixels);
std::string_view name(Quality quality);

// Steps per frame that studies try: 1 to 4096, powers of sqrt(2), rounded.
std::vector<long> ladder_of_steps();

// What is varied beside the step.
enum class Against { stiffness, damping };
std::string_view name(Against against);

// One run: a method, a step, a value of what is varied.
struct Cell {
    const Method* method = nullptr;
    long steps = 0;  // per frame
    double value = 0.0;
    double worst = 0.0;  // pixels, over the believed frames; infinite where it did not reach them
};

// Where methods hold and where they fail on a problem's rope.
struct StabilityMap {
    Problem problem;
    Against against = Against::stiffness;
    std::vector<const Method*> methods;
    std::vector<long> steps;     // per frame: ladder_of_steps()
    std::vector<double> values;  // stiffness 1e0 to 1e8, or damping 1e-4 to 1e2: sqrt(10) apart
    std::vector<Cell> cells;     // methods × values × steps, steps fastest

    // The problem at one of the values.
    Problem at(double value) const;

    // The fewest steps per frame that linear theory calls stable, per value; 0 where there is no such limit.
    std::vector<double> limit(const Method& method) const;
};

// How far a map has come: cells done and all cells.
using MapReport = std::function<void(long done, long all)>;

// Runs every method that fits the problem at every step and value; each value has a truth of its own.
StabilityMap stability_map(const Problem& problem, Against against, const std::vector<const Method*>& methods,
                           const MapReport& report);

// Every cell as a line of CSV; lines that begin with # say what was studied and `made_by` what.
std::string to_csv(const StabilityMap& map, std::string_view made_by);

// The gnuplot script that draws the map, a panel for each method, from "stability.csv" in the folder it is
// run in into "stability.png" and "stability.svg".
std::string stability_script(const StabilityMap& map, const std::string& heading);

}  // namespace ropesim
