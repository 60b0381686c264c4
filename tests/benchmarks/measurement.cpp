#include "benchmarks/measurement.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <map>
#include <vector>

namespace ropesim {
namespace {

std::map<std::string, double>& units_of_all() {
    static std::map<std::string, double> units;
    return units;
}

std::map<std::string, std::vector<double>>& times_of_all() {
    static std::map<std::string, std::vector<double>> times;
    return times;
}

class Collector : public benchmark::BenchmarkReporter {
  public:
    bool ReportContext(const Context&) override { return true; }

    void ReportRuns(const std::vector<Run>& runs) override {
        for (const Run& run : runs)
            if (run.run_type == Run::RT_Iteration)
                times_of_all()[run.run_name.function_name].push_back(run.GetAdjustedCPUTime());
    }
};

}  // namespace

void measure(const std::string& name, double units, std::function<void()> run) {
    units_of_all()[name] = units;
    benchmark::RegisterBenchmark(name.c_str(), [run = std::move(run)](benchmark::State& state) {
        for (auto _ : state) run();
    });
}

bool take_turns(int count, char** values) {
    std::vector<char*> arguments(values, values + count);
    std::string options[] = {"--benchmark_repetitions=11", "--benchmark_min_time=0.01",
                             "--benchmark_enable_random_interleaving=true"};
    for (std::string& option : options) arguments.push_back(option.data());
    int arguments_count = static_cast<int>(arguments.size());
    benchmark::Initialize(&arguments_count, arguments.data());
    if (benchmark::ReportUnrecognizedArguments(arguments_count, arguments.data())) return false;
    Collector collector;
    benchmark::RunSpecifiedBenchmarks(&collector);
    return true;
}

double nanoseconds(const std::string& name) {
    std::vector<double>& times = times_of_all()[name];
    if (times.empty()) return 0.0;
    std::sort(times.begin(), times.end());
    return times[times.size() / 2] / units_of_all()[name];
}

}  // namespace ropesim
