#include "sweep/sweep_chart.h"

#include "scene/words.h"
#include "sweep_scripts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace ropesim {
namespace {

std::string setting(const char* name, const std::string& value) {
    return std::string(name) + " = " + value + '\n';
}

std::string setting(const char* name, double value) {
    std::array<char, 32> text;
    std::snprintf(text.data(), text.size(), "%.9g", value);
    return setting(name, text.data());
}

// The values as numbers; empty where one is none.
std::vector<double> numbers(const Variation& variation) {
    std::vector<double> result;
    for (const std::string& value : variation.values) {
        char* end = nullptr;
        result.push_back(std::strtod(value.c_str(), &end));
        if (end == value.c_str() || *end != 0) return {};
    }
    return result;
}

// Whether the numbers are better seen by their ratios.
bool on_log_axis(const std::vector<double>& values) {
    constexpr double wide = 20.0;
    if (values.empty()) return false;
    const auto [least, most] = std::ranges::minmax_element(values);
    return *least > 0.0 && *most >= wide * *least;
}

// A label for every value, or for some where they would stand too close.
std::string tics(const char* axis, const Variation& variation, std::size_t most) {
    const std::size_t every = (variation.values.size() + most - 1) / most;
    std::string list;
    for (std::size_t i = 0; i < variation.values.size(); i += every)
        list += (list.empty() ? "" : ", ") + in_gnuplot_quotes(variation.values[i]) + ' ' + std::to_string(i);
    return std::string("set ") + axis + " (" + list + ")\n";
}

// Whole decades about the positive numbers; 1 to 10 where there are none.
template <class Number>
std::string decades(const char* name, const std::vector<PointResult>& results, const Number& number) {
    double least = 0.0;
    double most = 0.0;
    for (const PointResult& each : results) {
        const double value = number(each);
        if (!(value > 0.0)) continue;
        least = least > 0.0 ? std::min(least, value) : value;
        most = std::max(most, value);
    }
    const double low = least > 0.0 ? std::pow(10.0, std::floor(std::log10(least))) : 1.0;
    const double high = most > 0.0 ? std::pow(10.0, std::ceil(std::log10(most))) : 1.0;
    return setting((std::string(name) + "_least").c_str(), low) +
           setting((std::string(name) + "_most").c_str(), std::max(high, 10.0 * low));
}

std::string curves(const Variation& variation) {
    constexpr std::size_t most_labels = 16;
    const std::vector<double> values = numbers(variation);
    std::string script = setting("x_label", in_gnuplot_quotes(variation.key)) +
                         setting("values", std::to_string(variation.values.size()));
    if (values.empty())
        return script + "position(d) = column(\"point\")\nset xrange [-0.5 : values - 0.5]\n" +
               tics("xtics", variation, most_labels);
    const auto [least, most] = std::ranges::minmax_element(values);
    const bool log = on_log_axis(values);
    const double margin = log ? std::pow(*most / *least, 0.03) : 0.03 * (*most - *least);
    return script + "position(d) = column(2)\n" + (log ? "set logscale x\n" : "") +
           setting("x_least", log ? *least / margin : *least - margin) +
           setting("x_most", log ? *most * margin : *most + margin) + "set xrange [x_least : x_most]\n";
}

std::string heat_map(const Variation& down, const Variation& across) {
    constexpr std::size_t most_across = 8;
    constexpr std::size_t most_down = 24;
    return setting("x_label", in_gnuplot_quotes(across.key)) +
           setting("y_label", in_gnuplot_quotes(down.key)) +
           setting("columns", std::to_string(across.values.size())) +
           setting("rows", std::to_string(down.values.size())) + tics("xtics", across, most_across) +
           tics("ytics", down, most_down);
}

}  // namespace

bool has_chart(const Sweep& sweep) {
    return sweep.variations.size() <= 2 && std::ranges::any_of(sweep.variations, [](const Variation& each) {
               return each.values.size() > 1;
           });
}

std::string sweep_script(const Sweep& sweep, const std::vector<PointResult>& results) {
    const std::vector<Variation>& variations = sweep.variations;
    const std::string title = sweep.scene.title.empty() ? "Sweep" : "Sweep: " + sweep.scene.title;
    const bool one = variations.size() == 1;
    return "# To draw the chart again: gnuplot sweep.gp\n" + setting("heading", in_gnuplot_quotes(title)) +
           decades("error", results,
                   [](const PointResult& each) { return each.error ? each.error->pixels : 0.0; }) +
           decades("work", results,
                   [](const PointResult& each) { return each.failure.empty() ? each.work : 0.0; }) +
           (one ? curves(variations[0]) : heat_map(variations[0], variations[1])) + '\n' +
           std::string(sweep_scripts()[one ? 0 : 1].second);
}

}  // namespace ropesim
