#pragma once

#include "scene/problems.h"
#include "scene/scene.h"
#include "scene/toml.h"
#include "scene/words.h"

#include <algorithm>
#include <charconv>
#include <stdexcept>

namespace ropesim {

// What is of no file has no place either.
[[noreturn]] inline void fail(std::string_view file, const toml::source_region& where,
                              const std::string& what) {
    if (file.empty()) throw std::runtime_error(what);
    throw std::runtime_error(std::string(file) + ":" + std::to_string(where.begin.line) + ":" +
                             std::to_string(where.begin.column) + ": " + what);
}

inline const char* type_of(const toml::node& node) {
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

// What is said of a key that is none of the known ones.
inline std::string unknown_key(std::string_view key, const std::string& where,
                               const std::vector<std::string_view>& known) {
    const std::string nearest = suggestion(key, known);
    std::string all;
    for (const std::string_view each : known) all += (all.empty() ? "" : ", ") + std::string(each);
    return "unknown key '" + printable(key) + "'" + where +
           (nearest.empty() ? "; " : "; did you mean '" + nearest + "'? ") + "expected one of: " + all;
}

// Reads the keys of one table into members that hold the defaults.
class TableReader {
  public:
    static constexpr bool reads = true;

    // `title` is how the table is called in messages, such as "[[rope]]".
    TableReader(const toml::table& table, std::string_view title, std::string_view file)
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
            fail(file_, key.source(), unknown_key(key.str(), " in " + std::string(title_), known_));
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
        TableReader reader(*node.as_table(), "view", file_);
        view_fields(reader, member);
        reader.refuse_unknown_keys();
    }

    const toml::table& table_;
    std::string_view title_;
    std::string_view file_;
    std::vector<std::string_view> known_;
};

}  // namespace ropesim
