#include "diff/scene_keys.h"

#include <algorithm>
#include <string_view>

namespace ropesim {
namespace {

struct Entry {
    std::string key;
    std::string value;
};

// The lines of the scene's TOML, each key with the table it stands in.
std::vector<Entry> entries(const Scene& scene) {
    const std::string toml = to_toml(scene);
    std::vector<Entry> result;
    std::string table;
    std::size_t ropes = 0;
    for (std::size_t begin = 0; begin < toml.size();) {
        const std::size_t end = toml.find('\n', begin);
        const std::string line = toml.substr(begin, end - begin);
        begin = end + 1;
        const std::size_t equals = line.find(" = ");
        if (line == "[[rope]]")
            table = "rope '" + scene.ropes[ropes++].name + "': ";
        else if (line.starts_with('['))
            table = line.substr(1, line.size() - 2) + ": ";
        else if (equals != std::string::npos)
            result.push_back({table + line.substr(0, equals), line.substr(equals + 3)});
    }
    return result;
}

std::string value_of(const std::string& key, const std::vector<Entry>& scene) {
    const auto entry = std::ranges::find(scene, key, &Entry::key);
    return entry == scene.end() ? "" : entry->value;
}

}  // namespace

std::vector<KeyDifference> key_differences(const Scene& expected, const Scene& actual) {
    const std::vector<Entry> before = entries(expected);
    const std::vector<Entry> after = entries(actual);
    std::vector<KeyDifference> differences;
    for (const Entry& entry : before) {
        const std::string value = value_of(entry.key, after);
        if (value != entry.value) differences.push_back({entry.key, entry.value, value});
    }
    for (const Entry& entry : after)
        if (value_of(entry.key, before).empty()) differences.push_back({entry.key, "", entry.value});
    return differences;
}

std::string to_string(const KeyDifference& difference) {
    const auto shown = [](const std::string& value) { return value.empty() ? "none" : value; };
    return difference.key + " " + shown(difference.expected) + " -> " + shown(difference.actual);
}

}  // namespace ropesim
