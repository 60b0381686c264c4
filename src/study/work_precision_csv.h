#pragma once

#include "study/work_precision.h"

#include <string>
#include <string_view>

namespace ropesim {

// Every number of a study, a line per run. Ahead of it, in lines that begin with #, what was studied and the
// `made_by`: program and machine. Errors in pixels, infinite where a run failed; times in seconds per frame.
std::string to_csv(const WorkPrecision& study, std::string_view made_by);

// "AMD Ryzen 7 3700X, 16 processors", as far as the machine says.
std::string machine();

}  // namespace ropesim
