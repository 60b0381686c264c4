#include "compare/comparison_chart.h"

#include "compare/compared_scene.h"
#include "comparison_scripts.h"
#include "scene/words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace ropesim {
namespace {

// Whole decades about all distances that are not zero.
std::string range(const Parting& parting) {
    double least = 1.0;
    double most = 1.0;
    for (const auto& runs : parting.frames) {
        for (const ComparedFrame& run : runs) {
            if (!run.apart || run.apart->greatest <= 0.0) continue;
            least = std::min(least, run.apart->greatest);
            most = std::max(most, run.apart->greatest);
        }
    }
    std::array<char, 64> text;
    std::snprintf(text.data(), text.size(), "set yrange [1e%.0f : 1e%.0f]\n", std::floor(std::log10(least)),
                  std::floor(std::log10(most)) + 1.0);
    return text.data();
}

}  // namespace

std::string comparison_script(const Scene& scene, const Parting& parting) {
    const std::string count = std::to_string(scene.ropes.size() - 1);
    std::string script = "# To draw the chart again: gnuplot comparison.gp\nruns = " + count +
                         "\narray label[" + count + "]\n";
    for (std::size_t i = 1; i < scene.ropes.size(); ++i)
        script +=
            "label[" + std::to_string(i) + "] = " + in_gnuplot_quotes(label(scene, scene.ropes[i])) + "\n";
    script +=
        "first = " + in_gnuplot_quotes(label(scene, scene.ropes.front())) + "\n" + range(parting) + "\n";
    return script + std::string(comparison_scripts().front().second);
}

}  // namespace ropesim
