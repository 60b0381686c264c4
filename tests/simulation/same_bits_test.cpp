// Positions are the same bits in any optimisation level.
#include "simulation/every_method.h"
#include "simulation/motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

namespace ropesim {
namespace {

struct SameBits : testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Table, SameBits, every_method(), row_name);

std::string output(const std::string& command) {
    std::string text;
    FILE* pipe = popen(command.c_str(), "r");
    if (!pipe) return text;
    char part[4096];
    while (std::fgets(part, sizeof part, pipe)) text += part;
    pclose(pipe);
    return text;
}

// ROPESIM_UNOPTIMIZED is the program built from the same sources without optimisation.
TEST_P(SameBits, WithoutOptimisation) {
    const std::string here = motion(GetParam());
    EXPECT_GE(std::count(here.begin(), here.end(), '\n'), 17);
    EXPECT_EQ(here, output("'" ROPESIM_UNOPTIMIZED "' " + std::string(GetParam().name)));
}

}  // namespace
}  // namespace ropesim
