// README says what the program says.

#include "clip/file.h"
#include "clip/temporary_folder.h"
#include "commands/program.h"
#include "simulation/method.h"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <sstream>
#include <string>

namespace ropesim {
namespace {

using testing::HasSubstr;

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
    EXPECT_THAT(std::string(bytes.begin(), bytes.end()), HasSubstr(table));
}

// The rows of README's table of accuracy are what its command prints.
TEST(Readme, HasTheErrorsThatItsCommandPrints) {
    const std::vector<std::uint8_t> bytes = read_file(ROPESIM_README);
    const std::string text(bytes.begin(), bytes.end());
    EXPECT_THAT(text, HasSubstr("ropesim simulate seed-undamped --method stormer_verlet -s 64 --frames 0:20 "
                                "-o verlet.csv --truth truth.csv\n"));
    const std::string header =
        "| method | steps per frame | in frame 20 | in frame 60 |\n|---|---|---|---|\n";
    ASSERT_THAT(text, HasSubstr(header));
    std::istringstream table(text.substr(text.find(header) + header.size()));
    int rows = 0;
    for (std::string row; std::getline(table, row) && !row.empty(); ++rows) {
        std::string method(32, ' ');
        std::string steps(32, ' ');
        std::array<std::string, 2> pixels{std::string(32, ' '), std::string(32, ' ')};
        ASSERT_EQ(std::sscanf(row.c_str(), "| `%31[a-z_0-9]` | %31[0-9] | %31[-e0-9.] | %31[-e0-9.] |",
                              method.data(), steps.data(), pixels[0].data(), pixels[1].data()),
                  4)
            << row;
        const TemporaryFolder folder;
        for (std::size_t i = 0; i < 2; ++i) {
            const std::string frame = i == 0 ? "20" : "60";
            const Outcome outcome = ropesim(
                folder.path(), {"simulate", "seed-undamped", "--method", method.c_str(), "-s", steps.c_str(),
                                "--frames", "0:" + frame, "-o", "x.csv", "--truth", "t.csv"});
            std::string expected = ", ";
            expected.append(pixels[i].c_str()).append(" px in frame ").append(frame);
            EXPECT_THAT(outcome.err, HasSubstr(expected)) << row;
        }
    }
    EXPECT_EQ(rows, 8);
}

}  // namespace
}  // namespace ropesim
