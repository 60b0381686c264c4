// README says what the program says.

#include "clip/file.h"
#include "simulation/method.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <string>

namespace ropesim {
namespace {

std::string row(const Method& method) {
    std::array<char, 16> limit;
    std::snprintf(limit.data(), limit.size(), "%.4g", method.stability_limit);
    return "| `" + std::string(method.name) + "` | " + std::string(name(method.model)) + " | " +
           std::to_string(method.order) + " | " +
           (std::isinf(method.stability_limit) ? "none" : limit.data()) + " | " + letters(method.keeps) +
           " | " + std::string(method.purpose) + " |\n";
}

TEST(Readme, HasTheTableOfMethods) {
    const std::vector<std::uint8_t> bytes = read_file(ROPESIM_README);
    std::string table = "| method | model | order | h*omega < | keeps | for |\n|---|---|---|---|---|---|\n";
    for (const Method& method : methods()) table += row(method);
    EXPECT_THAT(std::string(bytes.begin(), bytes.end()), testing::HasSubstr(table));
}

}  // namespace
}  // namespace ropesim
