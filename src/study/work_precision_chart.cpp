#include "study/work_precision_chart.h"

#include "chart_scripts.h"
#include "scene/words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>

namespace ropesim {
namespace {

// Colours that the colour-blind tell apart (Okabe, Ito: Color Universal Design, 2008), and marks for when
// there is no colour at all.
constexpr std::array<const char*, 7> colors{"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                            "#000000", "#56b4e9", "#e69f00"};
constexpr const char* gray = "#7f7f7f";
constexpr std::array<int, 6> full_marks{7, 5, 9, 11, 13, 15};
constexpr std::array<int, 6> hollow_marks{6, 4, 8, 10, 12, 14};

constexpr double lost = 1e3;  // pixels: farther off than a picture is wide

std::string text(double number) {
    std::array<char, 32> buffer;
    std::snprintf(buffer.data(), buffer.size(), "%.4g", number);
    return buffer.data();
}

double work_of(const WorkPrecision& study, const Measurement& run, Work work) {
    if (work == Work::time) return run.time.median;
    const double passes = static_cast<double>(run.cost.evaluations + run.cost.solves);
    return passes / static_cast<double>(std::min(run.frames, study.problem.frames - 1));
}

double decade_below(double number) {
    return std::pow(10.0, std::floor(std::log10(number)));
}

std::string ranges(const WorkPrecision& study, Work work) {
    double finest = 1.0;
    double least = std::numeric_limits<double>::infinity();
    double most = 0.0;
    for (const Curve& curve : study.curves) {
        for (const Measurement& run : curve.measurements) {
            if (run.worst > 0.0) finest = std::min(finest, run.worst);
            least = std::min(least, work_of(study, run, work));
            most = std::max(most, work_of(study, run, work));
        }
    }
    finest = std::clamp(std::min(finest, study.truth.error) / 2.0, 1e-14, 1e-3);
    return "lost = " + text(lost) + "\nfinest = " + text(decade_below(finest)) +
           "\nleast = " + text(decade_below(least)) + "\nmost = " + text(10.0 * decade_below(most)) + "\n";
}

// Least work of a curve that keeps to half a pixel; infinite where it never does.
double work_at_half_a_pixel(const WorkPrecision& study, const Curve& curve, Work work) {
    double least = std::numeric_limits<double>::infinity();
    for (const Measurement& run : curve.measurements)
        if (run.worst <= 0.5) least = std::min(least, work_of(study, run, work));
    return least;
}

// Ours before others', each the cheapest at half a pixel first.
std::vector<const Curve*> ranked(const WorkPrecision& study, Work work) {
    std::vector<const Curve*> curves;
    for (const Curve& curve : study.curves) curves.push_back(&curve);
    const auto rank = [&](const Curve* curve) {
        return std::pair(!curve->contender.library.empty(), work_at_half_a_pixel(study, *curve, work));
    };
    std::stable_sort(curves.begin(), curves.end(),
                     [&](const Curve* a, const Curve* b) { return rank(a) < rank(b); });
    return curves;
}

bool ours(const Curve& curve) {
    return curve.contender.library.empty();
}

// A gnuplot array with an entry for each curve.
std::string array(const char* name, const std::vector<const Curve*>& curves,
                  const std::function<std::string(const Curve&)>& entry) {
    std::string script = "array " + std::string(name) + "[curves] = [";
    for (const Curve* curve : curves) script += (curve == curves.front() ? "" : ", ") + entry(*curve);
    return script + "]\n";
}

// The numbers, from 1 on, of the curves for which something is so of any run.
std::string numbers(const char* name, const std::vector<const Curve*>& curves,
                    const std::function<bool(const Curve&)>& holds) {
    std::string script = std::string(name) + " = \"";
    for (std::size_t i = 0; i < curves.size(); ++i)
        if (holds(*curves[i])) script += std::to_string(i + 1) + " ";
    return script + "\"\n";
}

bool holds_somewhere(const Curve& curve) {
    return std::any_of(curve.measurements.begin(), curve.measurements.end(),
                       [](const Measurement& run) { return run.worst < lost; });
}

bool fails_somewhere(const Curve& curve) {
    return std::any_of(curve.measurements.begin(), curve.measurements.end(),
                       [](const Measurement& run) { return !(run.worst < lost); });
}

}  // namespace

std::string work_precision_script(const WorkPrecision& study, Work work, const std::string& name,
                                  const std::string& heading) {
    const std::vector<const Curve*> curves = ranked(study, work);
    std::string script = "# To draw the chart again: gnuplot " + name + ".gp\n";
    script +=
        "data = \"work_precision.csv\"\nname = " + in_gnuplot_quotes(name) +
        "\nheading = " + in_gnuplot_quotes(heading) + "\nby_count = " + (work == Work::count ? "1" : "0") +
        "\nframes = " + std::to_string(study.problem.frames - 1) + "\ntruth = " + text(study.truth.error) +
        "\n" + ranges(study, work) + "curves = " + std::to_string(curves.size()) + "\n";
    // By its place in the table, so that a method looks the same in every chart.
    const auto row = [&](const Curve& curve) {
        return static_cast<std::size_t>(&curve - study.curves.data());
    };
    script += array("library", curves,
                    [](const Curve& curve) { return in_gnuplot_quotes(curve.contender.library); });
    script +=
        array("method", curves, [](const Curve& curve) { return in_gnuplot_quotes(curve.contender.name); });
    script +=
        array("label", curves, [](const Curve& curve) { return in_gnuplot_quotes(label(curve.contender)); });
    script += array("color", curves, [&](const Curve& curve) {
        return in_gnuplot_quotes(ours(curve) ? colors[row(curve) % colors.size()] : gray);
    });
    script += array("mark", curves, [&](const Curve& curve) {
        return std::to_string((ours(curve) ? full_marks : hollow_marks)[row(curve) % full_marks.size()]);
    });
    script += array("dash", curves, [](const Curve& curve) {
        return ours(curve) ? "1" : curve.contender.library == "odeint" ? "2" : "3";
    });
    script += numbers("drawn", curves, holds_somewhere);
    script += numbers("never_held", curves, [](const Curve& curve) { return !holds_somewhere(curve); });
    script += numbers("failing", curves, fails_somewhere);
    return script + "\n" + std::string(chart_scripts()[0].second);
}

}  // namespace ropesim
