#include "scene/problems.h"
#include "scene/scene.h"
#include "scene/words.h"

// toml++ 3.3 asserts that a header such as "[=]" has a key, just before it reports that there is none.
#define TOML_ASSERT(expression) static_assert(true)
#include <toml++/toml.h>

#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace ropesim {
namespace {

[[noreturn]] void fail(std::string_view file, const toml::source_region& where, const std::string& what) {
    throw std::runtime_error(std::string(file) + ":" + std::to_string(where.begin.line) + ":" +
                             std::to_string(where.begin.column) + ": " + what);
}

const char* type_of(const toml::node& node) {
    switch (node.type()) {
        case toml::node_type::table:
            return "a table";
        case toml::node_type::array:
            return "an array";
        case toml::node_type::string:
            return "a string";
        case toml::node_type::integer:
            return "a whole number";
        case toml::node_type::floating_point:
            return "a number";
        case toml::node_type::boolean:
            return "true or false";
        default:
            return "a date or time";
    }
}

// Reads the keys of one table into members that hold the defaults.
class Reader {
  public:
    static constexpr bool reads = true;

    // `title` is how the table is called in messages, such as "[[rope]]".
    Reader(const toml::table& table, std::string_view title, std::string_view file)
        : table_(table), title_(title), file_(file) {}

    template <class Member, class... Bounds>
    void field(const char* key, Member&& member, const Bounds&... bounds) {
        known_.push_back(key);
        if (const toml::node* node = table_.get(key)) read(key, *node, member, bounds...);
    }

    void know(const char* key) { known_.push_back(key); }

    // Throws where the table has a key that no field has asked for.
    void refuse_unknown_keys() const {
        for (const auto& [key, node] : table_) {
            if (std::find(known_.begin(), known_.end(), key.str()) != known_.end()) continue;
            const std::string nearest = suggestion(key.str(), known_);
            std::string all;
            for (const std::string_view each : known_) all += (all.empty() ? "" : ", ") + std::string(each);
            fail(file_, key.source(),
                 "unknown key '" + printable(key.str()) + "' in " + std::string(title_) +
                     (nearest.empty() ? "; " : "; did you mean '" + nearest + "'? ") +
                     "expected one of: " + all);
        }
    }

    // Blames the key's value, or the table where it has no such key.
    [[noreturn]] void fail_at(const std::string& key, const std::string& what) const {
        const toml::node* node = table_.get(key);
        fail(file_, node ? node->source() : table_.source(), key + ": " + what);
    }

    bool has(const char* key) const { return table_.contains(key); }

  private:
    [[noreturn]] void fail_type(const char* key, const toml::node& node, const char* expected) const {
        fail(file_, node.source(), std::string(key) + ": found " + type_of(node) + ", expected " + expected);
    }

    void require(const char* key, const toml::node& node, const std::optional<std::string>& problem) const {
        if (problem) fail(file_, node.source(), std::string(key) + " " + *problem);
    }

    const toml::array& array(const char* key, const toml::node& node, const char* expected) const {
        if (!node.is_array()) fail_type(key, node, expected);
        return *node.as_array();
    }

    const toml::array& array_of(const char* key, const toml::node& node, std::size_t size,
                                const char* expected) const {
        const toml::array& values = array(key, node, expected);
        if (values.size() != size)
            fail(file_, node.source(),
                 std::string(key) + ": found " + std::to_string(values.size()) + " values, expected " +
                     expected);
        return values;
    }

    void read(const char* key, const toml::node& node, double& member, const Range& range) const {
        if (node.is_integer())
            member = static_cast<double>(node.as_integer()->get());
        else if (node.is_floating_point())
            member = node.as_floating_point()->get();
        else
            fail_type(key, node, "a number");
        require(key, node, problem_of_number(member, range));
        member += 0.0;  // -0 is 0
    }

    void read(const char* key, const toml::node& node, int& member, const Range& range) const {
        if (!node.is_integer()) fail_type(key, node, "a whole number");
        require(key, node, problem_of_number(static_cast<double>(node.as_integer()->get()), range));
        member = static_cast<int>(node.as_integer()->get());
    }

    void read(const char* key, const toml::node& node, bool& member) const {
        if (!node.is_boolean()) fail_type(key, node, "true or false");
        member = node.as_boolean()->get();
    }

    void read(const char* key, const toml::node& node, std::string& member) const {
        if (!node.is_string()) fail_type(key, node, "a string");
        member = node.as_string()->get();
        require(key, node, problem_of_text(member));
    }

    void read(const char* key, const toml::node& node, const MethodName<std::string>& member) const {
        read(key, node, member.name);
        if (const auto problem = problem_of_method(member.name)) fail(file_, node.source(), *problem);
    }

    template <class Number>
    void read(const char* key, const toml::node& node, std::optional<Number>& member,
              const Range& range) const {
        read(key, node, member.emplace(), range);
    }

    void read(const char* key, const toml::node& node, Eigen::Array2d& member, const Range& range) const {
        const toml::array& values = array_of(key, node, 2, "two numbers");
        for (std::size_t i = 0; i < 2; ++i) read(key, values[i], member[static_cast<Eigen::Index>(i)], range);
    }

    void read(const char* key, const toml::node& node, std::array<int, 2>& member, const Range& range) const {
        const toml::array& values = array_of(key, node, 2, "two whole numbers, width and height");
        for (std::size_t i = 0; i < 2; ++i) read(key, values[i], member[i], range);
    }

    template <class Value>
    void read(const char* key, const toml::node& node, std::vector<Value>& member, const Range& range) const {
        member.clear();
        for (const toml::node& each : array(key, node, "an array")) {
            Value value{};
            read(key, each, value, range);
            member.push_back(value);
        }
    }

    void read(const char* key, const toml::node& node, std::array<std::uint8_t, 3>& member) const {
        static constexpr const char* expected = "a colour such as \"#0080ff\"";
        if (!node.is_string()) fail_type(key, node, expected);
        const std::string& text = node.as_string()->get();
        std::uint32_t rgb = 0;
        const char* const end = text.data() + text.size();
        if (text.size() != 7 || text[0] != '#' || std::from_chars(text.data() + 1, end, rgb, 16).ptr != end)
            fail(file_, node.source(),
                 std::string(key) + ": found '" + printable(text) + "', expected " + expected);
        member = {static_cast<std::uint8_t>(rgb >> 16), static_cast<std::uint8_t>(rgb >> 8 & 0xff),
                  static_cast<std::uint8_t>(rgb & 0xff)};
    }

    void read(const char* key, const toml::node& node, View& member) const {
        if (!node.is_table()) fail_type(key, node, "a table { center, height }");
        Reader reader(*node.as_table(), "view", file_);
        view_fields(reader, member);
        reader.refuse_unknown_keys();
    }

    const toml::table& table_;
    std::string_view title_;
    std::string_view file_;
    std::vector<std::string_view> known_;
};

SceneRope read_rope(const toml::node& node, std::size_t number, std::string_view file) {
    if (!node.is_table())
        fail(file, node.source(), std::string("rope: found ") + type_of(node) + ", expected [[rope]]");
    Reader reader(*node.as_table(), "[[rope]]", file);
    SceneRope rope;
    rope.name = "rope " + std::to_string(number);
    rope_fields(reader, rope);
    reader.refuse_unknown_keys();
    for (const char* key : {"start", "end"})
        if (!reader.has(key)) reader.fail_at(key, "is missing; expected two numbers, world units");
    if (reader.has("mass") && reader.has("masses"))
        reader.fail_at("masses", "expected either mass (of every node) or masses (one each), not both");
    if (reader.has("masses") && rope.masses.empty()) reader.fail_at("masses", found_masses(0, rope.nodes));
    if (const auto problem = problem_of_rope(rope)) reader.fail_at(problem->key, problem->what);
    return rope;
}

std::vector<SceneRope> read_ropes(const toml::table& table, std::string_view file) {
    const toml::node* node = table.get("rope");
    if (!node) fail(file, table.source(), "no rope; expected at least one [[rope]]");
    if (!node->is_array() || node->as_array()->empty())
        fail(file, node->source(),
             std::string("rope: found ") + type_of(*node) + ", expected one or more [[rope]]");
    if (node->as_array()->size() > static_cast<std::size_t>(most_ropes))
        fail(file, node->source(), "more than " + std::to_string(most_ropes) + " ropes");
    std::vector<SceneRope> ropes;
    for (const toml::node& each : *node->as_array()) ropes.push_back(read_rope(each, ropes.size() + 1, file));
    if (const auto found = problem_of_ropes(ropes))
        Reader(*node->as_array()->get(found->rope)->as_table(), "[[rope]]", file)
            .fail_at(found->problem.key, found->problem.what);
    return ropes;
}

Scene read_scene(const toml::table& table, std::string_view file) {
    Scene scene;
    Reader top(table, "the scene", file);
    scene_fields(top, scene);
    top.know("clip");
    top.know("rope");
    top.refuse_unknown_keys();
    if (const toml::node* node = table.get("clip")) {
        if (!node->is_table())
            fail(file, node->source(), std::string("clip: found ") + type_of(*node) + ", expected [clip]");
        Reader clip(*node->as_table(), "[clip]", file);
        clip_fields(clip, scene);
        clip.refuse_unknown_keys();
    }
    scene.ropes = read_ropes(table, file);
    return scene;
}

}  // namespace

Scene parse_scene(std::string_view toml, std::string_view name) {
    try {
        return read_scene(toml::parse(toml), name);
    } catch (const toml::parse_error& error) {
        fail(name, error.source(), std::string(error.description()));
    }
}

std::string toml_library() {
    return "toml++ " + std::to_string(TOML_LIB_MAJOR) + "." + std::to_string(TOML_LIB_MINOR) + "." +
           std::to_string(TOML_LIB_PATCH);
}

}  // namespace ropesim
