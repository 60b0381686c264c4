#include "scene/problems.h"

#include "scene/path.h"
#include "scene/words.h"
#include "simulation/diagnostics.h"
#include "simulation/method.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <unordered_set>

namespace ropesim {
namespace {

constexpr std::size_t longest_text = 200;

// Links shorter than this have no direction that arithmetic could tell.
constexpr double shortest_link = 1e-9;

// A number for a message: 3 and 1000000, not 3.0 and 1e+06.
std::string plain(double number) {
    constexpr double all_digits = 1e15;
    if (number == std::trunc(number) && std::abs(number) < all_digits)
        return std::to_string(static_cast<long>(number));
    return number_text(number);
}

std::optional<KeyProblem> problem_of_pins(const SceneRope& rope) {
    std::vector<int> pins;
    for (const int pin : rope.pinned) {
        if (pin < -rope.nodes || pin >= rope.nodes)
            return KeyProblem{"pinned", "node " + std::to_string(pin) + " does not exist, expected " +
                                            std::to_string(-rope.nodes) + " to " +
                                            std::to_string(rope.nodes - 1)};
        pins.push_back(pin < 0 ? pin + rope.nodes : pin);
    }
    std::sort(pins.begin(), pins.end());
    const auto twice = std::adjacent_find(pins.begin(), pins.end());
    if (twice != pins.end())
        return KeyProblem{"pinned", "node " + std::to_string(*twice) + " is pinned twice"};
    return std::nullopt;
}

// Whether a corner, start or end is where the next one is.
bool has_a_corner_twice(const SceneRope& rope) {
    std::vector<Eigen::Array2d> corners{rope.start};
    corners.insert(corners.end(), rope.via.begin(), rope.via.end());
    corners.push_back(rope.end);
    return std::adjacent_find(corners.begin(), corners.end(),
                              [](const auto& a, const auto& b) { return (a == b).all(); }) != corners.end();
}

std::optional<KeyProblem> problem_of_path(const SceneRope& rope) {
    const char* const key = rope.via.empty() ? "end" : "via";
    if (has_a_corner_twice(rope))
        return KeyProblem{key, rope.via.empty()
                                   ? "start and end are the same point, expected two"
                                   : "two corners in a row of start, via, end are the same point"};
    const Points points = points_along(rope);
    for (Eigen::Index i = 0; i + 1 < points.rows(); ++i)
        if (!((points.row(i + 1) - points.row(i)).square().sum() >= shortest_link * shortest_link))
            return KeyProblem{key, "nodes " + std::to_string(i) + " and " + std::to_string(i + 1) +
                                       " are in the same place, expected neighbours at least " +
                                       number_text(shortest_link) + " apart"};
    return std::nullopt;
}

// Direct projection keeps the lengths that links start with, and so must be given the right ones.
std::optional<KeyProblem> problem_of_lengths(const SceneRope& rope) {
    if (rope.method != "direct_projection") return std::nullopt;
    const Points points = points_along(rope);
    const double rest_length = rope.rest_length.value_or(path_length(rope) / (rope.nodes - 1));
    for (Eigen::Index i = 0; i + 1 < points.rows(); ++i) {
        const double length = std::sqrt((points.row(i + 1) - points.row(i)).square().sum());
        if (is_rest_length(rest_length, length)) continue;
        return KeyProblem{rope.rest_length   ? "rest_length"
                          : rope.via.empty() ? "end"
                                             : "via",
                          "link " + std::to_string(i) + " starts " + number_text(length) +
                              " long, and direct_projection expects its rest length, " +
                              number_text(rest_length)};
    }
    return std::nullopt;
}

std::optional<KeyProblem> problem_of_masses(const SceneRope& rope) {
    if (rope.masses.empty()) return std::nullopt;
    if (rope.mass != SceneRope().mass)
        return KeyProblem{"masses", "expected either mass (of every node) or masses (one each), not both"};
    if (rope.masses.size() != static_cast<std::size_t>(rope.nodes))
        return KeyProblem{"masses", found_masses(rope.masses.size(), rope.nodes)};
    return std::nullopt;
}

}  // namespace

std::string number_text(double number) {
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), number + 0.0);
    std::string text(digits.data(), end.ptr);
    return text.find_first_of(".en") == std::string::npos ? text + ".0" : text;
}

std::optional<std::string> problem_of_text(const std::string& text) {
    if (text.size() > longest_text)
        return "has " + std::to_string(text.size()) + " bytes, expected at most " +
               std::to_string(longest_text);
    if (!is_plain(text)) return "holds a control character or bytes that are not UTF-8";
    return std::nullopt;
}

std::optional<std::string> problem_of_method(const std::string& name) {
    if (name == auto_method) return std::nullopt;
    try {
        find_method(name);
        return std::nullopt;
    } catch (const std::runtime_error& error) {
        return error.what();
    }
}

std::optional<std::string> problem_of_number(double number, const Range& range) {
    const bool low_enough = range.below ? number < range.greatest : number <= range.greatest;
    if (number >= range.least && low_enough) return std::nullopt;
    return "is " + plain(number) + ", expected " + plain(range.least) + " to " +
           (range.below ? "below " : "") + plain(range.greatest);
}

std::string found_masses(std::size_t masses, int nodes) {
    return "found " + std::to_string(masses) + " masses for " + std::to_string(nodes) +
           " nodes, expected one for each";
}

std::optional<KeyProblem> problem_of_rope(const SceneRope& rope) {
    if (rope.name.empty()) return KeyProblem{"name", "is empty"};
    if (auto problem = problem_of_masses(rope)) return problem;
    if (rope.damping > 0.0 && rope.damping_factor > 0.0)
        return KeyProblem{"damping_factor",
                          "expected either damping (a rate) or damping_factor (per step), not both"};
    if (auto problem = problem_of_path(rope)) return problem;
    if (auto problem = problem_of_lengths(rope)) return problem;
    return problem_of_pins(rope);
}

std::optional<RopeProblem> problem_of_ropes(const std::vector<SceneRope>& ropes) {
    std::unordered_set<std::string_view> names;
    long masses = 0;
    for (std::size_t i = 0; i < ropes.size(); ++i) {
        if (!names.insert(ropes[i].name).second)
            return RopeProblem{i, {"name", "another rope is called '" + printable(ropes[i].name) + "' too"}};
        masses += ropes[i].nodes;
        if (masses > most_masses)
            return RopeProblem{i,
                               {"nodes", "the ropes up to this one have " + std::to_string(masses) +
                                             " together, expected at most " + std::to_string(most_masses)}};
    }
    return std::nullopt;
}

}  // namespace ropesim
