#include "study/work_precision_csv.h"

#include <array>
#include <cstdio>
#include <fstream>
#include <thread>

namespace ropesim {
namespace {

constexpr std::string_view header =
    "library,method,model,order,steps_per_frame,tolerance,h_omega,stable,frames_reached,worst_px,last_px,"
    "evaluations,solves,lower_quartile_s,median_s,upper_quartile_s,repetitions\n";

// Six digits are more than a time has; errors are the same on every machine and keep all theirs.
std::string text(double number, int digits) {
    std::array<char, 40> buffer;
    std::snprintf(buffer.data(), buffer.size(), "%.*g", digits, number);
    return buffer.data();
}

std::string exact(double number) {
    return text(number, 17);
}

std::string rough(double number) {
    return text(number, 6);
}

std::string line(const Contender& contender, const Measurement& run) {
    const bool steps = contender.setting == Setting::steps_per_frame;
    const std::string model(contender.method ? name(contender.method->model) : "elastic");
    std::string line = contender.library + ',' + contender.name + ',' + model + ',';
    if (contender.order > 0) line += std::to_string(contender.order);
    line += ',' + (steps ? rough(run.setting) : "") + ',' + (steps ? "" : rough(run.setting)) + ',';
    if (steps) line += exact(run.h_omega);
    line += std::string(",") + (run.stable ? "1" : "0") + ',' + std::to_string(run.frames) + ',' +
            exact(run.worst) + ',' + exact(run.last) + ',' + std::to_string(run.cost.evaluations) + ',' +
            std::to_string(run.cost.solves);
    for (const double seconds : {run.time.lower, run.time.median, run.time.upper})
        line += ',' + rough(seconds);
    return line + ',' + std::to_string(run.time.repetitions) + '\n';
}

}  // namespace

std::string to_csv(const WorkPrecision& study, std::string_view made_by) {
    const Problem& problem = study.problem;
    std::string csv = "# " + std::string(made_by) + "\n# " + std::to_string(problem.rope.mass.size()) +
                      " masses; " + std::string(name(problem.model)) + "; " + std::to_string(problem.frames) +
                      " frames, of which the truth is believed in " + std::to_string(study.truth.frames) +
                      ", to " + rough(study.truth.error) + " px\n";
    csv += header;
    for (const Curve& curve : study.curves)
        for (const Measurement& run : curve.measurements) csv += line(curve.contender, run);
    return csv;
}

std::string machine() {
    std::ifstream file("/proc/cpuinfo");
    std::string processor = "unknown processor";
    for (std::string row; std::getline(file, row);) {
        if (!row.starts_with("model name")) continue;
        processor = row.substr(row.find(':') + 2);
        break;
    }
    return processor + ", " + std::to_string(std::thread::hardware_concurrency()) + " processors";
}

}  // namespace ropesim
