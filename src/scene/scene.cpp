#include "scene/scene.h"

#include "builtin_files.h"
#include "scene/path.h"
#include "scene/problems.h"
#include "scene/words.h"

#include <algorithm>
#include <stdexcept>

namespace ropesim {
namespace {

// Checks the members' ranges where they stand now.
class Checker {
  public:
    static constexpr bool reads = false;

    explicit Checker(std::string where) : where_(std::move(where)) {}

    template <class Member, class... Bounds>
    void field(const char* key, const Member& member, const Bounds&... bounds) {
        check(key, member, bounds...);
    }

    [[noreturn]] void fail(const std::string& key, const std::string& what) const {
        throw std::runtime_error(where_ + key + " " + what);
    }

  private:
    void require(const char* key, const std::optional<std::string>& problem) const {
        if (problem) fail(key, *problem);
    }

    void check(const char* key, double member, const Range& range) const {
        require(key, problem_of_number(member, range));
    }
    void check(const char* key, int member, const Range& range) const {
        check(key, static_cast<double>(member), range);
    }
    void check(const char* key, const std::string& member) const { require(key, problem_of_text(member)); }
    void check(const char*, const std::array<std::uint8_t, 3>&) const {}
    void check(const char*, bool) const {}

    void check(const char*, const MethodName<const std::string>& member) const {
        if (const auto problem = problem_of_method(member.name)) throw std::runtime_error(where_ + *problem);
    }

    template <class Number>
    void check(const char* key, const std::optional<Number>& member, const Range& range) const {
        if (member) check(key, *member, range);
    }

    template <class Numbers>
    void check(const char* key, const Numbers& member, const Range& range) const {
        for (const auto& number : member) check(key, number, range);
    }

    void check(const char*, const View& member) {
        Checker view(where_ + "view: ");
        view_fields(view, member);
    }

    std::string where_;
};

std::string rope_title(const SceneRope& rope) {
    return "rope '" + printable(rope.name) + "': ";
}

// The first line of a file, without "# ".
std::string_view summary(std::string_view toml) {
    std::string_view line = toml.substr(0, toml.find('\n'));
    line.remove_prefix(std::min(line.find_first_not_of("# "), line.size()));
    return line;
}

bool same(const Eigen::Array2d& a, const Eigen::Array2d& b) {
    return (a == b).all();
}

}  // namespace

bool operator==(const SceneRope& a, const SceneRope& b) {
    return a.name == b.name && a.method == b.method && same(a.start, b.start) && same(a.end, b.end) &&
           std::equal(a.via.begin(), a.via.end(), b.via.begin(), b.via.end(), same) && a.nodes == b.nodes &&
           a.mass == b.mass && a.masses == b.masses && a.stiffness == b.stiffness &&
           a.rest_length == b.rest_length && a.pinned == b.pinned && a.damping == b.damping &&
           a.damping_factor == b.damping_factor && a.steps_per_frame == b.steps_per_frame &&
           a.sweeps == b.sweeps && a.color == b.color && a.line_width == b.line_width &&
           a.point_size == b.point_size;
}

bool operator==(const Scene& a, const Scene& b) {
    return a.title == b.title && same(a.gravity, b.gravity) && a.frames == b.frames &&
           a.steps_per_frame == b.steps_per_frame && a.frame_time == b.frame_time && a.size == b.size &&
           same(a.view.center, b.view.center) && a.view.height == b.view.height &&
           a.background == b.background && a.tolerance == b.tolerance && a.words == b.words &&
           a.ropes == b.ropes;
}

void check_scene(const Scene& scene) {
    Checker top("");
    scene_fields(top, scene);
    clip_fields(top, scene);
    if (scene.ropes.empty() || scene.ropes.size() > static_cast<std::size_t>(most_ropes))
        throw std::runtime_error("found " + std::to_string(scene.ropes.size()) + " ropes, expected 1 to " +
                                 std::to_string(most_ropes));
    if (const auto found = problem_of_ropes(scene.ropes))
        throw std::runtime_error(rope_title(scene.ropes[found->rope]) + found->problem.key + ": " +
                                 found->problem.what);
    for (const SceneRope& rope : scene.ropes) {
        Checker checker(rope_title(rope));
        rope_fields(checker, rope);
        if (const auto problem = problem_of_rope(rope)) checker.fail(problem->key + ":", problem->what);
    }
}

long masses(const Scene& scene) {
    long masses = 0;
    for (const SceneRope& rope : scene.ropes) masses += rope.nodes;
    return masses;
}

int steps_per_frame(const Scene& scene, const SceneRope& rope) {
    return rope.steps_per_frame.value_or(scene.steps_per_frame);
}

Rope make_rope(const Scene& scene, const SceneRope& description) {
    Rope rope;
    rope.start = points_along(description);
    rope.mass =
        description.masses.empty()
            ? Eigen::ArrayXd::Constant(description.nodes, description.mass)
            : Eigen::ArrayXd(Eigen::Map<const Eigen::ArrayXd>(description.masses.data(), description.nodes));
    for (const int pin : description.pinned) rope.pinned.push_back(pin < 0 ? pin + description.nodes : pin);
    rope.gravity = scene.gravity;
    rope.rest_length = description.rest_length.value_or(path_length(description) / (description.nodes - 1));
    rope.stiffness = description.stiffness;
    rope.damping = description.damping;
    return finished(std::move(rope));
}

std::vector<BuiltinScene> builtin_scenes() {
    std::vector<BuiltinScene> scenes;
    for (const auto& [path, toml] : builtin_files())
        scenes.push_back({path.substr(0, path.find('/')), summary(toml), toml});
    return scenes;
}

const SceneRope& rope_named(const Scene& scene, std::string_view name) {
    constexpr std::size_t most_listed = 12;
    std::string known;
    for (std::size_t i = 0; i < scene.ropes.size(); ++i) {
        const SceneRope& rope = scene.ropes[i];
        if (name.empty() || rope.name == name) return rope;
        if (i < most_listed) known += (known.empty() ? "'" : ", '") + rope.name + "'";
    }
    if (scene.ropes.size() > most_listed)
        known += " and " + std::to_string(scene.ropes.size() - most_listed) + " more";
    throw std::runtime_error("no rope '" + printable(name) + "' in the scene; expected one of: " + known);
}

}  // namespace ropesim
