#pragma once

#include "diff/compare.h"

#include <string>
#include <vector>

namespace ropesim {

struct Accepted {
    std::vector<std::string> done;  // one line each: "frame_0012.png: replaced"
    std::vector<std::string> left;  // what was not done, and why
};

// Makes ACTUAL the expected: copies every frame that differs, is new or of another size over EXPECTED's. A
// frame that ACTUAL lacks, or that cannot be read, is left as it is. Throws where a file cannot be written.
Accepted accept(const Comparison& comparison);

}  // namespace ropesim
