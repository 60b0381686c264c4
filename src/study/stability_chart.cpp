#include "chart_scripts.h"
#include "scene/words.h"
#include "study/stability.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <functional>

namespace ropesim {
namespace {

std::string text(double number) {
    std::array<char, 32> buffer;
    std::snprintf(buffer.data(), buffer.size(), "%.6g", number);
    return buffer.data();
}

std::string array(const char* name, std::size_t size, const std::function<std::string(std::size_t)>& entry) {
    std::string script = "array " + std::string(name) + "[" + std::to_string(size) + "] = [";
    for (std::size_t i = 0; i < size; ++i) script += (i > 0 ? ", " : "") + entry(i);
    return script + "]\n";
}

// Half way between neighbours on a logarithmic axis, and as far outside.
template <class Numbers>
std::string edges(const char* name, const Numbers& numbers) {
    const auto edge = [&](std::size_t i) {
        const auto a = static_cast<double>(numbers[i]);
        return std::sqrt(a * static_cast<double>(numbers[i + 1]));
    };
    const std::size_t last = numbers.size() - 1;
    return array(name, numbers.size() + 1, [&](std::size_t i) {
        if (i > 0 && i <= last) return text(edge(i - 1));
        const auto end = static_cast<double>(numbers[i == 0 ? 0 : last]);
        return text(end * end / edge(i == 0 ? 0 : last - 1));
    });
}

// A row per value: the value, then each method's fewest stable steps.
std::string limits(const StabilityMap& map) {
    std::vector<std::vector<double>> of_method;
    for (const Method* method : map.methods) of_method.push_back(map.limit(*method));
    std::string rows = "$limits << EOD\nvalue";
    for (const Method* method : map.methods) rows += ',' + std::string(method->name);
    for (std::size_t v = 0; v < map.values.size(); ++v) {
        rows += '\n' + text(map.values[v]);
        for (const auto& each : of_method) rows += ',' + (each[v] > 0.0 ? text(each[v]) : "NaN");
    }
    return rows + "\nEOD\n";
}

bool limited(const StabilityMap& map, const Method& method) {
    for (const double steps : map.limit(method))
        if (steps > 0.0) return true;
    return false;
}

}  // namespace

std::string stability_script(const StabilityMap& map, const std::string& heading) {
    const std::size_t panels = map.methods.size();
    const auto name_of = [&](std::size_t i) { return in_gnuplot_quotes(map.methods[i]->name); };
    return "# To draw the chart again: gnuplot stability.gp\ndata = \"stability.csv\"\nagainst = \"" +
           std::string(name(map.against)) + "\"\nheading = " + in_gnuplot_quotes(heading) +
           "\npanels = " + std::to_string(panels) + "\n" + array("method", panels, name_of) +
           array("limited", panels,
                 [&](std::size_t i) { return limited(map, *map.methods[i]) ? "1" : "0"; }) +
           "steps = " + std::to_string(map.steps.size()) + "\nvalues = " + std::to_string(map.values.size()) +
           "\n" + edges("step_edge", map.steps) + edges("value_edge", map.values) + limits(map) + "\n" +
           std::string(chart_scripts()[1].second);
}

}  // namespace ropesim
