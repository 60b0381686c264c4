#include "study/stability.h"

#include "simulation/diagnostics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace ropesim {
namespace {

// Powers of sqrt(10), written out, since a power may be rounded differently elsewhere.
std::vector<double> ladder_of_values(Against against) {
    if (against == Against::stiffness)
        return {1e0,     3.162, 1e1,     31.62, 1e2,     316.2, 1e3,     3162.0, 1e4,
                3.162e4, 1e5,   3.162e5, 1e6,   3.162e6, 1e7,   3.162e7, 1e8};
    return {1e-4, 3.162e-4, 1e-3, 3.162e-3, 1e-2, 3.162e-2, 0.1, 0.3162, 1.0, 3.162, 10.0, 31.62, 100.0};
}

double worst_error(const Problem& problem, const Truth& truth, const Method& method, long steps) {
    return method_error(problem, truth, simulate(problem, method, steps).frames).worst;
}

std::string text(double number) {
    std::array<char, 32> buffer;
    std::snprintf(buffer.data(), buffer.size(), "%.6g", number);
    return buffer.data();
}

}  // namespace

std::vector<long> ladder_of_steps() {
    return {1,  2,   3,   4,   6,   8,   11,  16,   23,   32,   45,   64,
            91, 128, 181, 256, 362, 512, 724, 1024, 1448, 2048, 2896, 4096};
}

Quality quality(double worst_pixels) {
    if (worst_pixels <= 0.5) return Quality::exact;
    if (worst_pixels <= 8.0) return Quality::usable;
    return std::isfinite(worst_pixels) ? Quality::wrong : Quality::diverged;
}

std::string_view name(Quality quality) {
    constexpr std::array<std::string_view, 4> names{"exact", "usable", "wrong", "diverged"};
    return names[static_cast<std::size_t>(quality)];
}

std::string_view name(Against against) {
    return against == Against::stiffness ? "stiffness" : "damping";
}

Problem StabilityMap::at(double value) const {
    Problem result = problem;
    (against == Against::stiffness ? result.rope.stiffness : result.rope.damping) = value;
    return result;
}

std::vector<double> StabilityMap::limit(const Method& method) const {
    std::vector<double> result;
    for (const double value : values) {
        const auto fewest = method.stable
                                ? fewest_stable_steps(at(value).rope, method, problem.frame_time, 0.0)
                                : std::nullopt;
        result.push_back(fewest ? static_cast<double>(*fewest) : 0.0);
    }
    return result;
}

StabilityMap stability_map(const Problem& problem, Against against, const std::vector<const Method*>& methods,
                           const MapReport& report) {
    StabilityMap map{problem, against, methods, ladder_of_steps(), ladder_of_values(against), {}};
    map.cells.resize(methods.size() * map.values.size() * map.steps.size());
    long done = 0;
    for (std::size_t v = 0; v < map.values.size(); ++v) {
        const Problem at_value = map.at(map.values[v]);
        const Truth its_truth = truth(at_value);
        for (std::size_t m = 0; m < methods.size(); ++m) {
            for (std::size_t s = 0; s < map.steps.size(); ++s) {
                Cell& cell = map.cells[(m * map.values.size() + v) * map.steps.size() + s];
                cell = {methods[m], map.steps[s], map.values[v],
                        worst_error(at_value, its_truth, *methods[m], map.steps[s])};
                report(++done, static_cast<long>(map.cells.size()));
            }
        }
    }
    return map;
}

std::string to_csv(const StabilityMap& map, std::string_view made_by) {
    std::string csv = "# " + std::string(made_by) + "\n";
    csv += "method,model,steps_per_frame," + std::string(name(map.against)) + ",worst_px,quality,class\n";
    for (const Cell& cell : map.cells) {
        const Quality found = quality(cell.worst);
        csv += std::string(cell.method->name) + ',' + std::string(name(cell.method->model)) + ',' +
               std::to_string(cell.steps) + ',' + text(cell.value) + ',' + text(cell.worst) + ',' +
               std::string(name(found)) + ',' + std::to_string(static_cast<int>(found)) + '\n';
    }
    return csv;
}

}  // namespace ropesim
