#include "clip/helpers.h"

#include "clip/file.h"
#include "clip/frames.h"
#include "clip/temporary_folder.h"

#include <gmock/gmock.h>

#include <unistd.h>
#include <csignal>
#include <filesystem>
#include <functional>
#include <new>
#include <stdexcept>

namespace ropesim {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

class HelpersTest : public testing::Test {
  protected:
    void draw(long frame, const std::vector<Points>& positions) const {
        write_file(temporary.path() / frame_name(frame, 100), std::to_string(positions[0](0, 0)));
    }

    // The first eight frames, each of a rope whose mass is where the frame's number says.
    void draw_all(Helpers& helpers) const {
        for (long frame = 0; frame < 8; ++frame) {
            const std::vector<Points> positions{Points::Constant(1, 2, static_cast<double>(frame))};
            if (!helpers.take(frame, positions, helpers.count())) draw(frame, positions);
        }
        helpers.finish();
    }

    const pid_t parent = ::getpid();
    const std::vector<Points> one_mass{Points::Zero(1, 2)};
    const TemporaryFolder temporary;
};

TEST_F(HelpersTest, DrawWhatOneLeftThatWasKilled) {
    testing::internal::CaptureStderr();
    Helpers helpers(2, one_mass, [&](long frame, const std::vector<Points>& positions) {
        if (frame == 1 && ::getpid() != parent) std::raise(SIGKILL);
        draw(frame, positions);
    });
    draw_all(helpers);
    EXPECT_THAT(testing::internal::GetCapturedStderr(),
                HasSubstr("a job was ended by signal 9 (Killed); its frames are drawn again"));
    EXPECT_TRUE(helpers.any_died());
    EXPECT_EQ(helpers.count(), 1) << "the other goes on";
    EXPECT_THAT(frames_in(temporary.path()), ElementsAre(0, 1, 2, 3, 4, 5, 6, 7));
    for (long frame = 0; frame < 8; ++frame) {
        const auto bytes = read_file(temporary.path() / frame_name(frame, 100));
        EXPECT_EQ(std::string(bytes.begin(), bytes.end()), std::to_string(static_cast<double>(frame)));
    }
}

TEST_F(HelpersTest, DrawAllThoughAllHelpersWereKilled) {
    testing::internal::CaptureStderr();
    Helpers helpers(3, one_mass, [&](long frame, const std::vector<Points>& positions) {
        if (::getpid() != parent) std::raise(SIGKILL);
        draw(frame, positions);
    });
    draw_all(helpers);
    testing::internal::GetCapturedStderr();
    EXPECT_EQ(helpers.count(), 0);
    EXPECT_THAT(frames_in(temporary.path()), ElementsAre(0, 1, 2, 3, 4, 5, 6, 7));
}

// Frames that are larger than what a socket takes, and a rope that is not in them any more. The helper is at
// its first frame until this process has drawn one.
TEST_F(HelpersTest, DrawWhileThisProcessDrawsToo) {
    const std::vector<Points> ropes{Eigen::ArrayXd::LinSpaced(50'000, -1.0, 1.0).replicate(1, 2),
                                    Points(0, 2)};
    const std::filesystem::path third = temporary.path() / frame_name(2, 100);
    Helpers helpers(1, ropes, [&](long frame, const std::vector<Points>& positions) {
        while (frame == 0 && !std::filesystem::exists(third)) ::usleep(1000);
        if (positions.size() != 2 || (positions[0] != ropes[0]).any() || positions[1].rows() != 0)
            throw std::runtime_error("other positions");
        draw(frame, positions);
    });
    EXPECT_TRUE(helpers.take(0, ropes, 1));
    EXPECT_TRUE(helpers.take(1, ropes, 1));
    EXPECT_FALSE(helpers.take(2, ropes, 1)) << "it has enough to do";
    draw(2, ropes);
    helpers.finish();
    EXPECT_THAT(frames_in(temporary.path()), ElementsAre(0, 1, 2));
}

TEST_F(HelpersTest, DrawNoFrameOfMoreMassesThanTheyWereMadeFor) {
    Helpers helpers(1, one_mass, [&](long frame, const auto& positions) { draw(frame, positions); });
    EXPECT_FALSE(helpers.take(0, {Points::Zero(2, 2)}, 1));
    EXPECT_TRUE(helpers.take(1, one_mass, 1));
    helpers.finish();
    EXPECT_THAT(frames_in(temporary.path()), ElementsAre(1));
}

TEST_F(HelpersTest, FailWithTheReasonOfOneThatFailed) {
    testing::internal::CaptureStderr();
    Helpers helpers(2, one_mass,
                    [&](long, const std::vector<Points>&) { throw std::runtime_error("the disk is full"); });
    EXPECT_TRUE(helpers.take(0, one_mass, 2));
    EXPECT_THAT([&] { helpers.finish(); }, ThrowsMessage<std::runtime_error>("the disk is full"));
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "it is said once, by who asked";
}

TEST_F(HelpersTest, FailWithTheReasonOfOneThatFailedLater) {
    Helpers helpers(1, one_mass, [&](long frame, const std::vector<Points>& positions) {
        if (frame == 5) throw std::bad_alloc();
        draw(frame, positions);
    });
    const auto draw_until_it_fails = [&] {
        for (long frame = 0;;) frame += helpers.take(frame, one_mass, 1);
    };
    EXPECT_THAT(draw_until_it_fails, ThrowsMessage<std::runtime_error>("out of memory"));
    EXPECT_THAT(frames_in(temporary.path()), ElementsAre(0, 1, 2, 3, 4));
}

TEST_F(HelpersTest, FailForWantOfMemoryWhereNoExceptionMayPass) {
    testing::internal::CaptureStderr();
    const std::function<void()> fail = [] { throw std::bad_alloc(); };
    const auto fail_without_passing_it_on = [&]() noexcept { fail(); };
    Helpers helpers(1, one_mass, [&](long, const std::vector<Points>&) { fail_without_passing_it_on(); });
    EXPECT_TRUE(helpers.take(0, one_mass, 1));
    EXPECT_THAT([&] { helpers.finish(); }, ThrowsMessage<std::runtime_error>("out of memory"));
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

}  // namespace
}  // namespace ropesim
