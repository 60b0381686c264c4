#pragma once

#include "scene/fields.h"

#include <optional>
#include <string>
#include <string_view>

namespace ropesim {

// What is wrong with a scene: the key to blame and a sentence about its value.
struct KeyProblem {
    std::string key;
    std::string what;
};

// A text as it may stand in a picture and a message: UTF-8, no control characters, 200 bytes at most.
std::optional<std::string> problem_of_text(const std::string& text);
std::optional<std::string> problem_of_method(const std::string& name);
std::optional<std::string> problem_of_number(double number, const Range& range);

// What several keys of a rope decide together.
std::optional<KeyProblem> problem_of_rope(const SceneRope& rope);
std::string found_masses(std::size_t masses, int nodes);

// What the ropes decide together: names of their own, not too many masses. The rope is an index.
struct RopeProblem {
    std::size_t rope;
    KeyProblem problem;
};
std::optional<RopeProblem> problem_of_ropes(const std::vector<SceneRope>& ropes);

// A number as TOML has it, the shortest that reads back as the same double; always with a point or exponent;
// -0 is 0.
std::string number_text(double number);

}  // namespace ropesim
