#include "clip/video.h"

#include "clip/file.h"
#include "clip/frames.h"
#include "clip/process.h"
#include "clip/temporary_folder.h"
#include "image/png.h"

#include <gmock/gmock.h>
#include <sys/wait.h>

#include <cerrno>
#include <cstdlib>

namespace ropesim {
namespace {

using testing::HasSubstr;

std::string refusal(const std::filesystem::path& video, const FrameList& frames) {
    try {
        check_video(video, frames);
        return "";
    } catch (const std::runtime_error& error) {
        return error.what();
    }
}

TEST(CheckVideo, WantsMp4OrGif) {
    EXPECT_THAT(refusal("clip.avi", {0, 1}), HasSubstr("ends in .mp4 or .gif"));
}

TEST(CheckVideo, SaysThatFfmpegIsMissing) {
    const std::string path = std::getenv("PATH");
    ::setenv("PATH", "/nowhere", 1);
    const std::string message = refusal("clip.mp4", {0, 1});
    ::setenv("PATH", path.c_str(), 1);
    EXPECT_THAT(message, HasSubstr("needs ffmpeg, which is not installed"));
}

// With the installed ffmpeg; where there is none, nothing here can be shown.
class Video : public testing::Test {
  protected:
    void SetUp() override {
        if (!is_installed("ffmpeg") || !is_installed("ffprobe")) GTEST_SKIP() << "no ffmpeg";
        for (const long frame : frames) {
            Image image = filled(33, 21, {0, 0, 80});
            set_pixel(image, static_cast<int>(frame), 5, {255, 255, 255});
            write_file(folder.path() / frame_name(frame, 12), encode_png(image, {}));
        }
    }

    const TemporaryFolder folder;
    const FrameList frames{2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
};

TEST_F(Video, RefusesAGap) {
    EXPECT_THAT(refusal("clip.mp4", {0, 1, 3}), HasSubstr("0:1,3 leaves out frame 2"));
}

TEST_F(Video, HoldsEveryFrameAlsoOfOddSides) {
    for (const char* name : {"clip.mp4", "clip.gif"}) {
        const std::filesystem::path video = folder.path() / name;
        write_video(video, folder.path(), frames, 12);
        EXPECT_EQ(run_program({"ffprobe", "-v", "error", "-count_frames", "-show_entries",
                               "stream=nb_read_frames", "-of", "csv=p=0", video.string()},
                              "."),
                  "10\n")
            << name;
    }
}

TEST_F(Video, IsNotMadeWhereAFrameIsMissingAndAnOlderOneStays) {
    const std::filesystem::path video = folder.path() / "clip.mp4";
    write_file(video, std::string_view("older"));
    std::filesystem::remove(folder.path() / frame_name(6, 12));
    EXPECT_THROW(write_video(video, folder.path(), frames, 12), std::runtime_error);
    EXPECT_EQ(read_file(video).size(), 5u);
}

// A folder in the place of a frame is there, and cannot be read.
TEST_F(Video, LeavesNothingWhereItsFramesBreakOff) {
    const std::filesystem::path frame = folder.path() / frame_name(6, 12);
    std::filesystem::remove(frame);
    std::filesystem::create_directory(frame);
    EXPECT_THROW(write_video(folder.path() / "clip.mp4", folder.path(), frames, 12), std::runtime_error);
    EXPECT_EQ(::waitpid(-1, nullptr, 0), -1);  // no process either
    EXPECT_EQ(errno, ECHILD);
    for (const auto& entry : std::filesystem::directory_iterator(folder.path()))
        EXPECT_EQ(entry.path().extension(), ".png") << entry.path();
}

TEST_F(Video, IsNotMadeOfABrokenFrame) {
    write_file(folder.path() / frame_name(6, 12), std::string_view("no picture"));
    EXPECT_THROW(write_video(folder.path() / "clip.mp4", folder.path(), frames, 12), std::runtime_error);
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "clip.mp4"));
}

}  // namespace
}  // namespace ropesim
