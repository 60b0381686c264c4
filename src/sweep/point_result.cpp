#include "sweep/point_result.h"

#include "clip/csv.h"
#include "study/plan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <sstream>

namespace ropesim {
namespace {

// It is an estimate.
std::string three_digits(double number) {
    std::array<char, 32> text;
    std::snprintf(text.data(), text.size(), "%.3g", number);
    return text.data();
}

std::string exact(double number) {
    std::string text;
    append_number(text, number);
    return text;
}

double work_per_frame(const Simulation& simulation, std::size_t rope) {
    const Run& run = simulation.runs()[rope];
    const long frames = simulation.diverged(rope).value_or(simulation.frame());
    const double masses = static_cast<double>(run.rope.mass.size());
    return masses * work(run.rope, *run.method, simulation.cost(rope)) /
           static_cast<double>(std::max(1L, frames));
}

constexpr std::array<const char*, 3> bounds{"about", "more than", "less than"};

std::string line_begin(const Sweep& sweep, long point) {
    std::string line = std::to_string(point);
    for (const std::string& value : sweep.values(point)) line += ',' + quoted(value);
    return line + ',';
}

std::string unquoted(std::string_view field) {
    std::string result;
    for (std::size_t i = 0; i < field.size(); ++i)
        if (field[i] != '"' || (i > 0 && field[i - 1] == '"' && i + 1 < field.size())) result += field[i];
    return result;
}

}  // namespace

PointResult point_result(const Simulation& simulation) {
    PointResult result;
    for (std::size_t i = 0; i < simulation.runs().size(); ++i) {
        const Summary& summary = simulation.summaries()[i];
        result.work += work_per_frame(simulation, i);
        result.largest_stretch = std::max(result.largest_stretch, summary.largest_stretch);
        if (std::abs(summary.energy_drift()) > std::abs(result.energy_drift))
            result.energy_drift = summary.energy_drift();
        if (const auto frame = simulation.diverged(i))
            result.diverged = std::min(*frame, result.diverged.value_or(*frame));
        if (!simulation.error(i)) continue;
        const RopeError::Worst worst = simulation.error(i)->worst();
        if (!result.error || worst.pixels > result.error->pixels) result.error = worst;
    }
    if (result.diverged) result.error.reset();
    return result;
}

std::string sweep_csv_header(const Sweep& sweep) {
    std::string line = "point";
    for (const Variation& each : sweep.variations) line += ',' + quoted(each.key);
    return line + ",error_px,error_bound,work,largest_stretch,energy_drift,diverged_at,status,why\n";
}

std::string csv_line(const Sweep& sweep, long point, const PointResult& result) {
    std::string line = line_begin(sweep, point);
    if (!result.failure.empty()) return line + ",,,,,,failed," + quoted(result.failure) + '\n';
    line += (result.error ? three_digits(result.error->pixels) : "") + ',' +
            (result.error ? bounds[static_cast<std::size_t>(result.error->bound)] : "");
    for (const double number : {result.work, result.largest_stretch, result.energy_drift})
        line += ',' + exact(number);
    return line + ',' + (result.diverged ? std::to_string(*result.diverged) : "") + ',' +
           (result.diverged ? "diverged" : "ok") + ",\n";
}

std::optional<PointResult> parse_csv_line(const Sweep& sweep, long point, std::string_view line) {
    const std::string begin = line_begin(sweep, point);
    if (!line.starts_with(begin) || !line.ends_with('\n')) return std::nullopt;
    std::istringstream rest{std::string(line.substr(begin.size()))};
    std::array<std::string, 7> fields;
    for (std::string& field : fields) std::getline(rest, field, ',');
    PointResult result;
    std::string why;
    std::getline(rest, why);
    result.failure = unquoted(why);
    const auto number = [&](std::size_t i) { return std::strtod(fields[i].c_str(), nullptr); };
    const auto bound = std::ranges::find(bounds, fields[1]);
    if (!fields[0].empty() && bound != bounds.end())
        result.error = {static_cast<RopeError::Bound>(bound - bounds.begin()), number(0), 0};
    result.work = number(2);
    result.largest_stretch = number(3);
    result.energy_drift = number(4);
    if (!fields[5].empty()) result.diverged = std::lround(number(5));
    if (csv_line(sweep, point, result) != line) return std::nullopt;
    return result;
}

}  // namespace ropesim
