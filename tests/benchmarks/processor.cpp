#include "benchmarks/processor.h"

#include <fstream>

namespace ropesim {

std::string processor() {
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "an unknown processor";
}

}  // namespace ropesim
