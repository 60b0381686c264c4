#include "scene/key_length.h"
#include "scene/scene.h"
#include "scene/table_reader.h"

#include <stdexcept>

namespace ropesim {
namespace {

SceneRope read_rope(const toml::node& node, std::size_t number, std::string_view file) {
    if (!node.is_table())
        fail(file, node.source(), std::string("rope: found ") + type_of(node) + ", expected [[rope]]");
    TableReader reader(*node.as_table(), "[[rope]]", file);
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
    long masses = 0;
    for (const toml::node& each : *node->as_array()) {
        ropes.push_back(read_rope(each, ropes.size() + 1, file));
        masses += ropes.back().nodes;
        if (masses > most_masses) break;  // to be refused; each rope that is read takes time
    }
    if (const auto found = problem_of_ropes(ropes))
        TableReader(*node->as_array()->get(found->rope)->as_table(), "[[rope]]", file)
            .fail_at(found->problem.key, found->problem.what);
    return ropes;
}

Scene read_scene(const toml::table& table, std::string_view file) {
    Scene scene;
    TableReader top(table, "the scene", file);
    scene_fields(top, scene);
    top.know("clip");
    top.know("rope");
    top.refuse_unknown_keys();
    if (const toml::node* node = table.get("clip")) {
        if (!node->is_table())
            fail(file, node->source(), std::string("clip: found ") + type_of(*node) + ", expected [clip]");
        TableReader clip(*node->as_table(), "[clip]", file);
        clip_fields(clip, scene);
        clip.refuse_unknown_keys();
    }
    scene.ropes = read_ropes(table, file);
    return scene;
}

}  // namespace

Scene parse_scene(std::string_view toml, std::string_view name) {
    if (toml.size() > largest_scene)
        throw std::runtime_error(std::string(name) + ": found " + std::to_string(toml.size()) +
                                 " bytes of scene, expected at most " + std::to_string(largest_scene));
    if (const auto place = overlong_key(toml))
        throw std::runtime_error(std::string(name) + ":" + std::to_string(place->line) + ":" +
                                 std::to_string(place->column) + ": a key of more than " +
                                 std::to_string(most_key_parts) + " parts, expected fewer dots");
    try {
        return read_scene(toml::parse(toml), name);
    } catch (const toml::parse_error& error) {
        fail(name, error.source(), one_line(error.description()));
    }
}

std::string toml_library() {
    return "toml++ " + std::to_string(TOML_LIB_MAJOR) + "." + std::to_string(TOML_LIB_MINOR) + "." +
           std::to_string(TOML_LIB_PATCH);
}

}  // namespace ropesim
