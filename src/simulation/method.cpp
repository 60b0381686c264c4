#include "simulation/method.h"

#include <array>
#include <stdexcept>
#include <string>

namespace ropesim {
namespace {

const std::array<Method, 6> table{{
    {"explicit_euler", Model::elastic, 1, 0.0, nullptr, nullptr, ""},
    {"symplectic_euler", Model::elastic, 1, 2.0, nullptr, nullptr, ""},
    {"stormer_verlet", Model::elastic, 2, 2.0, nullptr, nullptr, ""},
    {"constraint_projection", Model::inextensible, 1, 0.0, nullptr, nullptr, ""},
    {"seed_verlet", Model::elastic, 1, 2.0, nullptr, nullptr, ""},
    {"seed_constraints", Model::inextensible, 1, 0.0, nullptr, nullptr, ""},
}};

}  // namespace

std::span<const Method> methods() {
    return table;
}

const Method& find_method(std::string_view name) {
    std::string known;
    for (const Method& method : table) {
        if (method.name == name) return method;
        known += (known.empty() ? "" : ", ") + std::string(method.name);
    }
    throw std::runtime_error("unknown method '" + std::string(name) + "'; expected one of: " + known);
}

}  // namespace ropesim
