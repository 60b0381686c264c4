#include "clip/helpers.h"

#include "clip/file.h"
#include "clip/frames.h"
#include "clip/temporary_folder.h"

#include <gmock/gmock.h>

#include <unistd.h>
#include <csignal>
#include <stdexcept>

namespace ropesim {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

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
    const TemporaryFolder temporary;
};

TEST_F(HelpersTest, DrawWhatOneLeftThatWasKilled) {
    testing::internal::CaptureStderr();
    Helpers helpers(2, [&](long frame, const std::vector<Points>& positions) {
        if (frame == 1 && ::getpid() != parent) std::raise(SIGKILL);
        draw(frame, positions);
    });
    draw_all(helpers);
    EXPECT_THAT(testing::internal::GetCapturedStderr(),
                HasSubstr("a job was ended by signal 9 (Killed); its frames are drawn again"));
    EXPECT_TRUE(helpers.any_died());
    EXPECT_EQ(helpers.count(), 1) << "the other goes on";
    EXPECT_THAT(frames_in(temporary.path()), ElementsAre(0, 1, 2, 3, 4, 5, 6, 7));
    const auto bytes = read_file(temporary.path() / "frame_0001.png");
    EXPECT_EQ(std::string(bytes.begin(), bytes.end()), std::to_string(1.0));
}

TEST_F(HelpersTest, DrawAllThoughAllHelpersWereKilled) {
    testing::internal::CaptureStderr();
    Helpers helpers(3, [&](long frame, const std::vector<Points>& positions) {
        if (::getpid() != parent) std::raise(SIGKILL);
        draw(frame, positions);
    });
    draw_all(helpers);
    testing::internal::GetCapturedStderr();
    EXPECT_EQ(helpers.count(), 0);
    EXPECT_THAT(frames_in(temporary.path()), ElementsAre(0, 1, 2, 3, 4, 5, 6, 7));
}

TEST_F(HelpersTest, FailWhereOneFailed) {
    Helpers helpers(2,
                    [&](long, const std::vector<Points>&) { throw std::runtime_error("the disk is full"); });
    const std::vector<Points> positions{Points::Zero(1, 2)};
    EXPECT_TRUE(helpers.take(0, positions, 2));
    EXPECT_THROW(helpers.finish(), std::runtime_error);
}

}  // namespace
}  // namespace ropesim
