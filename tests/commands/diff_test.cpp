// `ropesim diff` from outside: what it says of faults that clips have, and its exit status.

#include "clip/file.h"
#include "clip/frames.h"
#include "clip/positions.h"
#include "clip/temporary_folder.h"
#include "commands/program.h"
#include "image/png.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdlib>

namespace ropesim {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

// Frames 57 to 60 of the seed's scene in the folder `expected`.
class Diff : public testing::Test {
  protected:
    Diff() { render("expected", {}); }

    Outcome run(const std::vector<std::string>& arguments) const {
        return ropesim(temporary.path(), arguments);
    }

    void render(const char* folder, const std::vector<std::string>& more) const {
        std::vector<std::string> arguments = {"render",  "seed", "--frames", "57:60",  "--size",
                                              "480x320", "-o",   folder,     "--quiet"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        ASSERT_EQ(run(arguments).status, 0);
    }

    void copy_frames(const char* folder) const {
        std::filesystem::copy(temporary.path() / "expected", temporary.path() / folder);
    }

    // Compares `expected` with the folder; all it prints on stdout, and nothing is on stderr.
    Outcome diff(const std::string& folder, const std::vector<std::string>& more = {}) const {
        std::vector<std::string> arguments = {"diff", "expected", folder};
        arguments.insert(arguments.end(), more.begin(), more.end());
        const Outcome outcome = run(arguments);
        EXPECT_THAT(outcome.err, IsEmpty());
        return outcome;
    }

    std::filesystem::path frame(const char* folder, long number) const {
        return temporary.path() / folder / frame_name(number, 120);
    }

    std::string text_of(const std::string& name) const {
        const auto bytes = read_file(temporary.path() / name);
        return {bytes.begin(), bytes.end()};
    }

    // Paints background over what lies within three pixels of the middle of the last link of the rope Euler.
    void erase_link(const char* folder, long number) const {
        ASSERT_EQ(run({"simulate", "seed", "-o", "positions.csv", "--no-error"}).status, 0);
        const Scene scene = parse_scene(builtin_scenes().front().toml, "seed");
        const Points points = parse_positions(scene, text_of("positions.csv"), "").at(number)[0];
        const auto middle = ((points.row(14) + points.row(15)) / 2.0).eval();
        const auto path = frame(folder, number);
        const auto bytes = read_file(path);
        Image image = decode_png(bytes, path.string());
        for (int y = -3; y <= 3; ++y)
            for (int x = -3; x <= 3; ++x)
                set_pixel(image, static_cast<int>(240.0 + middle(0) / 2.0) + x,
                          static_cast<int>(160.0 - middle(1) / 2.0) + y, scene.background);
        write_file(path, encode_png(image, decode_png_texts(bytes, path.string())));
    }

    const TemporaryFolder temporary;
};

TEST_F(Diff, FindsAFolderTheSameAsItself) {
    const Outcome outcome = diff("expected");
    EXPECT_EQ(outcome.status, 0);
    EXPECT_EQ(outcome.out, "same: 4 frames\n");
}

TEST_F(Diff, NamesAFrameThatIsMissing) {
    copy_frames("actual");
    std::filesystem::remove(frame("actual", 58));
    const Outcome outcome = diff("actual");
    EXPECT_EQ(outcome.status, 3);
    EXPECT_EQ(outcome.out,
              "frame_0058.png: missing: only in EXPECTED\n"
              "why: missing in ACTUAL: frame 58\n"
              "1 of 4 frames differs: 58\n");
}

TEST_F(Diff, SaysThatOnlyTheDrawingChangedWhereALinkIsMissingInOneFrame) {
    copy_frames("actual");
    erase_link("actual", 59);
    const Outcome alone = diff("actual");
    EXPECT_EQ(alone.status, 3);
    EXPECT_THAT(alone.out, StartsWith("frame_0059.png: differs: "));
    EXPECT_THAT(alone.out, HasSubstr("why: something is not drawn in frame 59: "));
    EXPECT_THAT(alone.out, EndsWith("1 of 4 frames differs: 59\n"));
    for (const char* folder : {"expected", "actual"})
        std::filesystem::copy_file(temporary.path() / "positions.csv",
                                   temporary.path() / folder / "positions.csv");
    EXPECT_THAT(
        diff("actual").out,
        HasSubstr("why: the drawing changed in frame 59; every mass is where it was, to the last bit\n"));
}

TEST_F(Diff, SaysThatTheMotionMovedWhereTheStepIsAnother) {
    render("actual", {"-s", "63"});
    const Outcome outcome = diff("actual");
    EXPECT_EQ(outcome.status, 3);
    EXPECT_THAT(outcome.out, HasSubstr("why: the scenes differ: clip: steps_per_frame 64 -> 63\n"));
    EXPECT_THAT(outcome.out, HasSubstr("why: the motion moved: first in frame 1, mass "));
    EXPECT_THAT(outcome.out, EndsWith("4 of 4 frames differ: 57 to 60; first frame_0057.png\n"));
}

TEST_F(Diff, PassesTheSamePixelsFromAnotherTool) {
    copy_frames("actual");
    for (const char* format : {"rgb24", "rgba"}) {
        const std::string command = "ffmpeg -loglevel error -y -i " + frame("expected", 58).string() +
                                    " -pix_fmt " + format + " " + frame("actual", 58).string();
        ASSERT_EQ(std::system(command.c_str()), 0);
        const Outcome outcome = diff("actual", {"--threshold", "0"});
        EXPECT_EQ(outcome.status, 0) << format;
        EXPECT_EQ(outcome.out,
                  "why: only the file format changed, not a pixel: frame 58\n"
                  "same: 4 frames, 1 of them in other bytes with the same pixels\n")
            << format;
    }
}

TEST_F(Diff, NamesAFileThatIsCutOff) {
    copy_frames("actual");
    std::filesystem::resize_file(frame("actual", 60), 700);
    const Outcome outcome = diff("actual");
    EXPECT_EQ(outcome.status, 3);
    EXPECT_THAT(outcome.out, StartsWith("frame_0060.png: unreadable: actual/frame_0060.png: the file is cut "
                                        "off after 700 bytes"));
    EXPECT_THAT(outcome.out, EndsWith("why: unreadable: frame 60\n1 of 4 frames differs: 60\n"));
    EXPECT_EQ(run({"diff", frame("expected", 60).string(), frame("actual", 60).string()}).status, 1)
        << "nothing could be compared";
}

TEST_F(Diff, LeavesItsFindingsForPeopleAndMachines) {
    copy_frames("actual");
    std::filesystem::remove(frame("actual", 57));
    erase_link("actual", 60);
    const Outcome outcome =
        diff("actual", {"--report", "r.html", "--json", "r.json", "--junit", "r.xml", "--max-pixels", "1"});
    EXPECT_EQ(outcome.status, 3);
    EXPECT_THAT(text_of("r.html"), AllOf(HasSubstr("frame_0060.png"), EndsWith("</html>\n")));
    const auto json = nlohmann::json::parse(text_of("r.json"));
    EXPECT_EQ(json["status"], 3);
    EXPECT_EQ(json["summary"], "2 of 4 frames differ: 57, 60; first frame_0057.png");
    EXPECT_EQ(json["frames"][3]["verdict"], "different");
    EXPECT_THAT(text_of("r.xml"), HasSubstr("tests=\"4\" failures=\"2\""));
    EXPECT_THAT(diff("expected", {"--junit", "r.xml"}).out, StartsWith("same"));
    EXPECT_THAT(text_of("r.xml"), HasSubstr("tests=\"4\" failures=\"0\""));
}

TEST_F(Diff, AcceptsOnlyTheFramesThatDiffer) {
    copy_frames("actual");
    erase_link("actual", 59);
    std::filesystem::remove(frame("actual", 57));
    const Outcome both = diff("actual", {"--accept"});
    EXPECT_EQ(both.status, 3) << "one frame is still missing";
    EXPECT_THAT(both.out,
                EndsWith("accepted: frame_0059.png: replaced\n"
                         "left: frame_0057.png: only in EXPECTED; delete it there if it is to go\n"));
    EXPECT_EQ(read_file(frame("expected", 59)), read_file(frame("actual", 59)));
    EXPECT_TRUE(std::filesystem::exists(frame("expected", 57)));
}

TEST_F(Diff, AcceptsOneFrameOfSeveral) {
    render("actual", {"-s", "63"});
    const std::string name = frame_name(58, 120);
    const Outcome one = run({"diff", "expected/" + name, "actual/" + name, "--accept"});
    EXPECT_EQ(one.status, 0);
    EXPECT_THAT(one.out, EndsWith("accepted: " + name + ": replaced\n"));
    EXPECT_THAT(diff("actual").out, EndsWith("3 of 4 frames differ: 57, 59, 60; first frame_0057.png\n"));
}

TEST_F(Diff, RefusesWhatItCannotCompareInOneLine) {
    const auto refused = [&](const std::vector<std::string>& arguments, int status, const char* message) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, status) << outcome.err;
        EXPECT_THAT(outcome.err, AllOf(StartsWith("ropesim: "), HasSubstr(message)));
        EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
    };
    refused({"diff", "expected"}, 2, "ACTUAL is required");
    refused({"diff", "expected", "expected", "--threshold", "256"}, 2, "--threshold");
    refused({"diff", "expected", "nowhere"}, 1, "nowhere: no such file or folder");
    refused({"diff", "expected", "expected/frame_0057.png"}, 1, "a folder and a file");
    std::filesystem::create_directory(temporary.path() / "empty");
    refused({"diff", "empty", "empty"}, 1, "neither folder holds a .png file");
}

}  // namespace
}  // namespace ropesim
