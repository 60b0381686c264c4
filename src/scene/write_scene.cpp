#include "scene/problems.h"
#include "scene/scene.h"

#include <array>
#include <cstdio>

namespace ropesim {
namespace {

// Writes keys and values, one a line.
class Writer {
  public:
    static constexpr bool reads = false;

    template <class Member, class... Bounds>
    void field(const char* key, const Member& member, const Bounds&...) {
        if (!is_left_out(member)) text_ += std::string(key) + " = " + value(member) + "\n";
    }

    void header(const char* name) { text_ += std::string("\n") + name + "\n"; }
    const std::string& text() const { return text_; }

  private:
    template <class Member>
    static bool is_left_out(const Member&) {
        return false;
    }
    template <class Number>
    static bool is_left_out(const std::optional<Number>& member) {
        return !member;
    }
    static bool is_left_out(const std::vector<double>& masses) { return masses.empty(); }
    static bool is_left_out(const std::vector<Eigen::Array2d>& corners) { return corners.empty(); }

    static std::string value(double number) { return number_text(number); }
    static std::string value(int number) { return std::to_string(number); }
    static std::string value(bool claim) { return claim ? "true" : "false"; }
    template <class Number>
    static std::string value(const std::optional<Number>& number) {
        return value(*number);  // as is_left_out said
    }
    static std::string value(const MethodName<const std::string>& method) { return value(method.name); }

    // Control characters are none (problem_of_text); the rest stands as it is but for these two.
    static std::string value(const std::string& text) {
        std::string quoted = "\"";
        for (const char c : text) quoted += c == '"' || c == '\\' ? std::string{'\\', c} : std::string(1, c);
        return quoted + '"';
    }

    static std::string value(const std::array<std::uint8_t, 3>& color) {
        std::array<char, 12> digits;
        std::snprintf(digits.data(), digits.size(), "\"#%02x%02x%02x\"", color[0], color[1], color[2]);
        return digits.data();
    }

    template <class Values>
    static std::string value(const Values& values) {
        std::string text;
        for (const auto& each : values) text += (text.empty() ? "" : ", ") + value(each);
        return "[" + text + "]";
    }

    static std::string value(const View& view) {
        return "{ center = " + value(view.center) + ", height = " + value(view.height) + " }";
    }

    std::string text_;
};

}  // namespace

std::string to_toml(const Scene& scene) {
    Writer writer;
    scene_fields(writer, scene);
    writer.header("[clip]");
    clip_fields(writer, scene);
    for (const SceneRope& rope : scene.ropes) {
        writer.header("[[rope]]");
        rope_fields(writer, rope);
    }
    return writer.text();
}

}  // namespace ropesim
