#pragma once

#include "diff/cause.h"

#include <string>

namespace ropesim {

// The comparison for programs: verdict, tolerance, causes, and every frame with what was measured. Bytes of
// names that are not UTF-8 are replaced by U+FFFD.
std::string to_json(const Comparison& comparison, const Cause& cause);

// The comparison as JUnit's XML, each frame a test case, so that CI systems list frames as tests. What XML
// cannot hold (control characters, bytes that are not UTF-8) is replaced by U+FFFD.
std::string to_junit(const Comparison& comparison, const Cause& cause);

}  // namespace ropesim
