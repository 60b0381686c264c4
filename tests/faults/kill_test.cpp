// Renders are killed at random moments, and the folder they leave is resumed.

#include "clip/file.h"
#include "clip/frames.h"
#include "clip/temporary_folder.h"
#include "commands/program.h"
#include "scene/scene.h"

#include <gmock/gmock.h>

#include <sys/stat.h>

#include <chrono>
#include <csignal>
#include <map>
#include <random>
#include <thread>

namespace ropesim {
namespace {

#ifdef __SANITIZE_ADDRESS__
constexpr int kills = 20;
#else
constexpr int kills = 200;
#endif

using Clock = std::chrono::steady_clock;
using Bytes = std::vector<std::uint8_t>;

std::map<std::string, Bytes> files_in(const std::filesystem::path& folder) {
    std::map<std::string, Bytes> files;
    if (!std::filesystem::exists(folder)) return files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        files[entry.path().filename().string()] = read_file(entry.path());
    return files;
}

// Which file a name stands for, and since when.
struct Identity {
    ino_t inode;
    time_t seconds;
    long nanoseconds;

    bool operator==(const Identity&) const = default;
};

std::map<long, Identity> identities(const std::filesystem::path& folder, long frames) {
    std::map<long, Identity> result;
    if (!std::filesystem::exists(folder)) return result;
    for (const long frame : frames_in(folder)) {
        struct stat status {};
        ::stat((folder / frame_name(frame, frames)).c_str(), &status);
        result[frame] = {status.st_ino, status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
    }
    return result;
}

class Kills : public testing::Test {
  protected:
    void SetUp() override {
        scene = parse_scene(builtin_scenes().front().toml, "seed");
        scene.frames = 60;
        scene.size = {160, 120};
        write_file(temporary.path() / "small.toml", to_toml(scene));
        const auto start = Clock::now();
        ASSERT_EQ(ropesim(temporary.path(), {"render", "small.toml", "-o", "whole", "--quiet"}).status, 0);
        undisturbed = std::chrono::duration<double>(Clock::now() - start).count();
        whole = files_in(temporary.path() / "whole");
    }

    std::vector<std::string> resume(int jobs) const {
        return {"render",   "small.toml", "-o",     "killed",
                "--resume", "--quiet",    "--jobs", std::to_string(jobs)};
    }

    // Half of them within the time that a render takes in all, so that some come early and some late.
    void kill_after_a_while(pid_t process) {
        std::this_thread::sleep_for(std::chrono::duration<double>(
            std::uniform_real_distribution<double>(0.0, 1.5 * undisturbed)(random)));
        ::kill(process, SIGKILL);
        wait_for(process);
    }

    // Frames that were there are the same files still; the others are whole, or not there.
    void expect_nothing_made_twice(const std::map<long, Identity>& before) {
        const auto after = identities(killed, scene.frames);
        for (const auto& [frame, identity] : before)
            EXPECT_EQ(after.at(frame), identity) << "frame " << frame;
    }

    void expect_whole_when_resumed(int jobs) {
        const auto before = identities(killed, scene.frames);
        const Outcome outcome = ropesim(temporary.path(), resume(jobs));
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_TRUE(files_in(killed) == whole) << "the same bytes, and no temporary file";
        expect_nothing_made_twice(before);
        std::filesystem::remove_all(killed);
    }

    void kill_renders(int jobs, int count) {
        int interrupted = 0;
        std::size_t kept = 0;
        for (int i = 0; i < count; ++i) {
            SCOPED_TRACE("kill " + std::to_string(i));
            const auto before = identities(killed, scene.frames);
            kept += before.size();
            kill_after_a_while(start_ropesim(temporary.path(), resume(jobs)));
            expect_nothing_made_twice(before);
            const bool is_done = std::filesystem::exists(killed / "clip.json");
            if (!is_done) ++interrupted;
            if (is_done || i % 5 == 4) expect_whole_when_resumed(jobs);
            if (HasFailure()) return;
        }
        std::printf("%d kills, %d of them before the end; %zu frames found by what came next\n", count,
                    interrupted, kept);
    }

    Scene scene;
    const TemporaryFolder temporary;
    const std::filesystem::path killed = temporary.path() / "killed";
    std::map<std::string, Bytes> whole;
    double undisturbed = 0.0;  // seconds that a render takes
    std::mt19937 random{8};
};

TEST_F(Kills, LeaveWhatIsResumedByOneJob) {
    kill_renders(1, kills / 2);
}

TEST_F(Kills, LeaveWhatIsResumedByTwoJobs) {
    kill_renders(2, kills / 2);
}

}  // namespace
}  // namespace ropesim
