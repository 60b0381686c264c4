#include "clip/progress.h"

#include <gmock/gmock.h>

#include <pty.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <string>
#include <thread>

namespace ropesim {
namespace {

using testing::MatchesRegex;

// What three of ten frames, the first kept, say on a stderr that is this file.
void make_three_of_ten(int file) {
    std::fflush(stderr);
    const int old = ::dup(STDERR_FILENO);
    ::dup2(file, STDERR_FILENO);
    {
        Progress progress(10, "frames", true);
        progress.kept();
        std::this_thread::sleep_for(std::chrono::milliseconds(101));  // it says something ten times a second
        progress.done(3);
    }
    std::fflush(stderr);
    ::dup2(old, STDERR_FILENO);
    ::close(old);
}

std::string all_of(int file) {
    std::array<char, 1000> text;
    const ssize_t count = ::read(file, text.data(), text.size());
    return {text.data(), count > 0 ? static_cast<std::size_t>(count) : 0};
}

TEST(Progress, IsALineOnATerminalThatGoesAway) {
    int terminal = 0;
    int file = 0;
    if (::openpty(&terminal, &file, nullptr, nullptr, nullptr) != 0)
        GTEST_SKIP() << "no terminal can be made here: is /dev/pts mounted?";
    make_three_of_ten(file);
    EXPECT_THAT(all_of(terminal),
                MatchesRegex("\r3 of 9 frames, .* per second, [0-9]+:[0-9][0-9] left\x1b\\[K\r\x1b\\[K"));
    ::close(terminal);
    ::close(file);
}

TEST(Progress, SaysNothingElsewhere) {
    std::array<int, 2> ends;
    ASSERT_EQ(::pipe(ends.data()), 0);
    make_three_of_ten(ends[1]);
    ::close(ends[1]);
    EXPECT_EQ(all_of(ends[0]), "");
    ::close(ends[0]);
}

}  // namespace
}  // namespace ropesim
