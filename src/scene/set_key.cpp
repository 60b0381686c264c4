#include "scene/scene.h"
#include "scene/table_reader.h"

#include <algorithm>

namespace ropesim {
namespace {

// Lists the keys that a table may have.
class KeyLister {
  public:
    static constexpr bool reads = true;

    template <class Member, class... Bounds>
    void field(const char* key, Member&&, const Bounds&...) {
        using Value = std::remove_cvref_t<Member>;
        keys.push_back(key);
        if (std::is_same_v<Value, int> || std::is_same_v<Value, std::optional<int>>) whole.push_back(key);
    }

    bool has(std::string_view key) const { return std::find(keys.begin(), keys.end(), key) != keys.end(); }

    std::vector<std::string_view> keys;
    std::vector<std::string_view> whole;  // those that take one whole number
};

struct KnownKeys {
    KeyLister top;
    KeyLister clip;
    KeyLister rope;

    KnownKeys() {
        Scene scene;
        SceneRope any;
        scene_fields(top, scene);
        clip_fields(clip, scene);
        rope_fields(rope, any);
    }

    std::vector<std::string_view> all() const {
        std::vector<std::string_view> result = top.keys;
        result.insert(result.end(), clip.keys.begin(), clip.keys.end());
        for (const std::string_view key : rope.keys)
            if (!clip.has(key)) result.push_back(key);
        return result;
    }
};

// "rope[NAME]" or "rope[0]" of what stands before a key's dot.
std::size_t rope_of(const Scene& scene, std::string_view rope) {
    if (rope.starts_with("rope[") && rope.ends_with(']')) {
        const std::string_view which = rope.substr(5, rope.size() - 6);
        for (std::size_t i = 0; i < scene.ropes.size(); ++i)
            if (scene.ropes[i].name == which || std::to_string(i) == which) return i;
    }
    const std::size_t last = scene.ropes.size() - 1;
    throw std::runtime_error("no '" + printable(rope) + "' in the scene; expected clip, rope[0]" +
                             (last > 0 ? " to rope[" + std::to_string(last) + "]" : "") +
                             " or a rope by its name, rope[" + scene.ropes[0].name + "]");
}

// Where a key of a scene is: in its [clip], in these ropes, or at its top.
struct KeyPlace {
    std::string_view key;
    bool in_clip = false;
    std::vector<std::size_t> ropes{};
};

KeyPlace place_of(const Scene& scene, std::string_view key) {
    const std::size_t dot = key.rfind('.');
    if (dot != std::string_view::npos) {
        const std::string_view before = key.substr(0, dot);
        const std::string_view after = key.substr(dot + 1);
        if (before == "clip") return {after, true};
        return {after, false, {rope_of(scene, before)}};
    }
    const KnownKeys known;
    if (known.top.has(key)) return {key};
    if (known.clip.has(key)) return {key, true};
    if (!known.rope.has(key)) throw std::runtime_error(unknown_key(key, "", known.all()));
    KeyPlace place{key};
    for (std::size_t i = 0; i < scene.ropes.size(); ++i) place.ropes.push_back(i);
    return place;
}

// A table of one key. What is no value of TOML's is a word that nobody has put into quotes.
toml::table table_of(std::string_view key, std::string_view value) {
    if (!is_plain(value)) throw std::runtime_error("holds a control character or bytes that are not UTF-8");
    const std::string begin = std::string(key) + " = ";
    try {
        return toml::parse(begin + std::string(value));
    } catch (const toml::parse_error&) {
        try {
            return toml::parse(begin + "'" + std::string(value) + "'");
        } catch (const toml::parse_error&) {
            throw std::runtime_error("is neither a value nor a word");
        }
    }
}

void drop_what_it_replaces(std::string_view key, SceneRope& rope) {
    if (key == "mass") rope.masses.clear();
    if (key == "masses") rope.mass = SceneRope().mass;
    if (key == "damping") rope.damping_factor = 0.0;
    if (key == "damping_factor") rope.damping = 0.0;
}

}  // namespace

void set_key(Scene& scene, std::string_view key, std::string_view value) {
    const KeyPlace place = place_of(scene, key);
    const toml::table table = table_of(place.key, value);
    for (const std::size_t i : place.ropes) {
        TableReader rope(table, "[[rope]]", "");
        rope_fields(rope, scene.ropes[i]);
        rope.refuse_unknown_keys();
        drop_what_it_replaces(place.key, scene.ropes[i]);
    }
    if (!place.ropes.empty()) return;
    TableReader reader(table, place.in_clip ? "[clip]" : "the scene", "");
    place.in_clip ? clip_fields(reader, scene) : scene_fields(reader, scene);
    reader.refuse_unknown_keys();
    if (key == "steps_per_frame")
        for (SceneRope& rope : scene.ropes) rope.steps_per_frame.reset();
}

bool takes_whole_numbers(std::string_view key) {
    const KnownKeys known;
    const std::string_view last = key.substr(key.rfind('.') + 1);
    const auto in = [&](const KeyLister& table) {
        return std::find(table.whole.begin(), table.whole.end(), last) != table.whole.end();
    };
    return in(known.clip) || in(known.rope);
}

}  // namespace ropesim
