#include "clip/positions_file.h"

#include "clip/digest.h"
#include "clip/file.h"
#include "clip/some_positions.h"
#include "clip/temporary_folder.h"

#include <gmock/gmock.h>
#include <sys/stat.h>
#include <chrono>
#include <cmath>
#include <fstream>
#include <thread>

namespace ropesim {
namespace {

using testing::HasSubstr;

Positions all(const PositionsFile& file) {
    Positions positions;
    for (const long frame : file.frames()) positions[frame] = file.at(frame);
    return positions;
}

class PositionsFileTest : public testing::Test {
  protected:
    std::filesystem::path file(const char* name, const std::string& bytes) const {
        write_file(folder_.path() / name, bytes);
        return folder_.path() / name;
    }

    // A pipe into which the bytes go once.
    std::filesystem::path pipe(const std::string& bytes) {
        const std::filesystem::path path = folder_.path() / "pipe";
        EXPECT_EQ(::mkfifo(path.c_str(), 0600), 0);
        writer_ = std::jthread([=] { write_file(path, bytes, Place::named); });
        return path;
    }

    Scene scene_ = scene_of({{"a", 3}, {"b", 2}});
    Positions positions_ = random_positions(scene_, 4);

  private:
    TemporaryFolder folder_;
    std::jthread writer_;
};

TEST_F(PositionsFileTest, HoldsTheSameBitsInEitherFormatAndFromAPipe) {
    positions_[3][0] = Points(0, 2);
    for (const std::string& bytes : {to_csv(scene_, positions_), to_npy(scene_, positions_)}) {
        const PositionsFile read(scene_, file("positions", bytes));
        expect_same_bits(positions_, all(read));
        EXPECT_EQ(read.digest(), digest(bytes));
    }
    const std::string npy = to_npy(scene_, positions_);
    const PositionsFile piped(scene_, pipe(npy));
    expect_same_bits(positions_, all(piped));
    EXPECT_EQ(piped.digest(), digest(npy));
}

TEST_F(PositionsFileTest, MissesAFrameThatIsAskedForAndNotHeld) {
    positions_.erase(1);
    const PositionsFile some(scene_, file("some.csv", to_csv(scene_, positions_)));
    EXPECT_EQ(some.frames(), (FrameList{0, 2, 3}));
    EXPECT_NO_THROW(some.check_has({0, 2}));
    EXPECT_THROW(some.check_has({0, 1}), std::runtime_error);
}

TEST_F(PositionsFileTest, RefusesWhatIsNotFiniteBeforeAFrameIsAskedFor) {
    positions_[3][1](1, 1) = HUGE_VAL;
    EXPECT_THROW(PositionsFile(scene_, file("a.npy", to_npy(scene_, positions_))), std::runtime_error);
}

// In place, as numpy.save does it.
TEST_F(PositionsFileTest, StopsWhereTheFileHasChangedSince) {
    const auto expect_changed = [](const PositionsFile& read) {
        try {
            read.at(3);
            FAIL() << "read something else";
        } catch (const std::runtime_error& error) {
            EXPECT_THAT(error.what(), HasSubstr("a.npy: has changed while it was read"));
        }
    };
    const std::filesystem::path path = file("a.npy", to_npy(scene_, positions_));
    const PositionsFile cut(scene_, path);
    std::filesystem::resize_file(path, 200);
    expect_changed(cut);

    file("a.npy", to_npy(scene_, positions_));
    const PositionsFile written(scene_, path);
    EXPECT_NO_THROW(written.at(3));
    std::fstream(path, std::ios::in | std::ios::out).seekp(200).put('x');
    std::filesystem::last_write_time(path,
                                     std::filesystem::file_time_type::clock::now() + std::chrono::seconds(1));
    expect_changed(written);
}

}  // namespace
}  // namespace ropesim
