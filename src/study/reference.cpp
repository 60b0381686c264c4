#include "study/reference.h"

#include "simulation/diagnostics.h"
#include "study/sundials_run.h"
#include "study/taylor_run.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace ropesim {
namespace {

using Eigen::Index;

constexpr double length_tolerance = 1e-12;  // of the rest length
constexpr double line_tolerance = 1e-6;     // radians

// The rounding of 80 bits. Where long double has more of them they are in software, and no chart needs them.
constexpr long double finest_tolerance = 0x1p-63L;

Eigen::Vector2d link_of(const Rope& rope, Index link) {
    return (rope.start.row(link + 1) - rope.start.row(link)).transpose();
}

void check_lengths(const Rope& rope, Model model) {
    for (Index link = 0; link + 1 < rope.start.rows(); ++link) {
        const double length = link_of(rope, link).norm();
        const std::string where = "reference: link " + std::to_string(link) + " of the " +
                                  std::string(name(model)) + " rope starts at length " +
                                  std::to_string(length);
        if (length == 0.0) throw std::runtime_error(where + "; it needs a direction");
        if (model == Model::inextensible &&
            std::abs(length - rope.rest_length) > length_tolerance * rope.rest_length)
            throw std::runtime_error(where + "; expected its rest length, " +
                                     std::to_string(rope.rest_length));
    }
}

bool on_one_line(const Rope& rope, Index first_mass, Index last_mass) {
    const Eigen::Vector2d first = link_of(rope, first_mass).normalized();
    for (Index link = first_mass + 1; link < last_mass; ++link) {
        const Eigen::Vector2d other = link_of(rope, link).normalized();
        if (std::abs(first.x() * other.y() - first.y() * other.x()) > line_tolerance) return false;
    }
    return true;
}

void check_pins(const Rope& rope) {
    std::vector<Index> pins = rope.pinned;
    std::sort(pins.begin(), pins.end());
    for (std::size_t i = 1; i < pins.size(); ++i)
        if (pins[i] - pins[i - 1] >= 2 && on_one_line(rope, pins[i - 1], pins[i]))
            throw std::runtime_error("reference: the links between pinned masses " +
                                     std::to_string(pins[i - 1]) + " and " + std::to_string(pins[i]) +
                                     " of the inextensible rope lie on one line, where their tensions are "
                                     "not determined; expected "
                                     "slack between them");
}

}  // namespace

// The second run leaves out ten times as much, in series of another length: it takes other steps and rounds
// differently.
Reference reference(const Rope& rope, Model model, double frame_time, long frames) {
    check_lengths(rope, model);
    if (model == Model::inextensible) check_pins(rope);
    constexpr long double epsilon = std::max(std::numeric_limits<long double>::epsilon(), finest_tolerance);
    const TaylorPrecision finest{.order = 24, .tolerance = epsilon};
    const TaylorPrecision looser{.order = 20, .tolerance = 10.0L * epsilon};
    const Run truth = taylor_run(rope, model, frame_time, frames, finest);
    const Run second = taylor_run(rope, model, frame_time, frames, looser);
    Reference result;
    const std::size_t reached = std::min(truth.position.size(), second.position.size());
    for (std::size_t frame = 0; frame < reached; ++frame) {
        result.frames.push_back(truth.position[frame]);
        result.velocities.push_back(truth.velocity[frame]);
        result.error.push_back(greatest_distance(truth.position[frame], second.position[frame]));
    }
    return result;
}

std::vector<double> confirmation(const Reference& reference, const Rope& rope, Model model,
                                 double frame_time) {
    const Run other = sundials_run(rope, model, frame_time, static_cast<long>(reference.frames.size()));
    std::vector<double> distances;
    for (std::size_t frame = 0; frame < other.position.size(); ++frame)
        distances.push_back(greatest_distance(reference.frames[frame], other.position[frame]));
    return distances;
}

long believed_frames(const Reference& reference, double bound) {
    const auto first = std::find_if(reference.error.begin(), reference.error.end(),
                                    [&](double error) { return !(error <= bound); });
    return static_cast<long>(first - reference.error.begin());
}

}  // namespace ropesim
