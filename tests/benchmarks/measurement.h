#pragma once

#include <functional>
#include <string>

namespace ropesim {

// What a benchmark measures: `units` of work that `run` does, such as springs times steps.
void measure(const std::string& name, double units, std::function<void()> run);

// Measures all, in turns, so that whatever slows the machine slows all alike. False where an option of Google
// Benchmark is wrong.
bool take_turns(int count, char** values);

// Median nanoseconds of processor time that a unit took.
double nanoseconds(const std::string& name);

}  // namespace ropesim
