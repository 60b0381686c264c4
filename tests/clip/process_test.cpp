#include "clip/process.h"

#include "clip/chart.h"
#include "clip/temporary_folder.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <functional>
#include <stdexcept>
#include <string>

namespace ropesim {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string failure(const std::function<void()>& run) {
    try {
        run();
        return "";
    } catch (const std::runtime_error& error) {
        return error.what();
    }
}

TEST(RunProgram, RunsInTheFolderAndGivesWhatWasPrinted) {
    const TemporaryFolder temporary;
    EXPECT_EQ(run_program({"pwd"}, temporary.path()), temporary.path().string() + "\n");
}

TEST(RunProgram, SaysThatAProgramIsMissingOrFails) {
    const TemporaryFolder temporary;
    const auto run = [&](const char* program) {
        return failure([&] { run_program({program}, temporary.path()); });
    };
    EXPECT_EQ(run("no-such-program"), "cannot run no-such-program: No such file or directory");
    EXPECT_EQ(run("false"), "false failed");
}

TEST(RequireGnuplot, SaysWhichPackageHasIt) {
    const std::string path = std::getenv("PATH");
    ::setenv("PATH", "/nowhere", 1);
    const std::string missing = failure(require_gnuplot);
    ::setenv("PATH", path.c_str(), 1);
    EXPECT_THAT(missing, StartsWith("charts need gnuplot"));
    EXPECT_THAT(missing, HasSubstr("apt-get install gnuplot-nox"));
}

}  // namespace
}  // namespace ropesim
