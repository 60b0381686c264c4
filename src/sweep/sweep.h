#pragma once

#include "sweep/variation.h"

#include <string>
#include <vector>

namespace ropesim {

// A grid of scenes: one with every combination of the variations' values. The last variation varies fastest.
struct Sweep {
    Scene scene;
    std::vector<Variation> variations;

    long points() const;

    // Of each variation at a point, 0 <= point < points().
    std::vector<std::string> values(long point) const;

    // The scene of a point. What several keys decide together is not checked.
    Scene at(long point) const;
};

// Reads the variations and checks that no key is given twice and that the points are not too many. Throws
// std::runtime_error.
Sweep make_sweep(const Scene& scene, const std::vector<std::string>& variations);

// "point_0042": four digits, or as many as the last point needs.
std::string point_name(const Sweep& sweep, long point);

}  // namespace ropesim
