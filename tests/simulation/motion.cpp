#include "simulation/motion.h"

#include "simulation/simulate.h"

#include <cstdio>

namespace ropesim {

std::string motion(const Method& method) {
    constexpr Eigen::Index masses = 17;
    Rope rope;
    rope.start.resize(masses, 2);
    rope.mass.resize(masses);
    for (Eigen::Index i = 0; i < masses; ++i) {
        rope.start.row(i) << 3.0 * static_cast<double>(i), i % 2 == 0 ? 0.0 : 4.0;
        rope.mass(i) = 1.0 + 0.3 * static_cast<double>(i % 3);
    }
    rope.rest_length = 5.0;
    rope.pinned = {0, masses - 1};
    rope.damping = 0.1;
    rope = finished(rope);
    Stepping each = stepping(1.0, 48);
    each.damping_factor = 0.0001;
    std::string text;
    for (const Points& frame : simulate(rope, method, each, 11).frames)
        for (Eigen::Index i = 0; i < masses; ++i) {
            char line[80];
            std::snprintf(line, sizeof line, "%a %a\n", frame(i, 0), frame(i, 1));
            text += line;
        }
    return text;
}

}  // namespace ropesim
