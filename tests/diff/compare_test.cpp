#include "diff/compare.h"

#include "clip/file.h"
#include "diff/folders.h"
#include "image/png.h"

#include <gmock/gmock.h>

#include <sys/stat.h>

namespace ropesim {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::ThrowsMessage;

const Image black = filled(20, 10, {0, 0, 0});

Image with_pixel(Image image, int x, int y, Color color) {
    set_pixel(image, x, y, color);
    return image;
}

TEST_F(Folders, AreTheSameTwice) {
    put_both(0, black);
    put_both(1, with_pixel(black, 3, 4, {255, 0, 0}));
    EXPECT_THAT(verdicts(), ElementsAre(Verdict::same_bytes, Verdict::same_bytes));
    EXPECT_EQ(status(compared()), 0);
    const auto folder = temporary.path() / "expected";
    EXPECT_EQ(status(compare(folder, folder, {})), 0);
}

TEST_F(Folders, DifferByOnePixel) {
    put_both(0, black);
    put("expected", 1, black);
    put("actual", 1, with_pixel(black, 3, 4, {0, 0, 3}));
    EXPECT_THAT(verdicts(), ElementsAre(Verdict::same_bytes, Verdict::different));
    EXPECT_EQ(status(compared()), 3);
}

TEST_F(Folders, PassWithinTheToleranceAndNotBeyondIt) {
    put("expected", 0, black);
    put("actual", 0, with_pixel(with_pixel(black, 3, 4, {0, 0, 3}), 9, 9, {0, 2, 0}));
    EXPECT_THAT(verdicts({.channel = 3, .pixels = 0}), ElementsAre(Verdict::within));
    EXPECT_THAT(verdicts({.channel = 2, .pixels = 0}), ElementsAre(Verdict::different));
    EXPECT_THAT(verdicts({.channel = 2, .pixels = 1}), ElementsAre(Verdict::within));
    EXPECT_THAT(verdicts({.channel = 1, .pixels = 1}), ElementsAre(Verdict::different));
}

TEST_F(Folders, NameEveryFrameThatIsMissingOrExtraAndLookAtTheOthers) {
    put("expected", 0, black);
    put("expected", 1, black);
    put("actual", 1, black);
    put("actual", 2, black);
    put("expected", 3, black);
    put("actual", 3, filled(20, 10, {255, 255, 255}));
    EXPECT_THAT(verdicts(),
                ElementsAre(Verdict::missing, Verdict::same_bytes, Verdict::extra, Verdict::different));
    EXPECT_EQ(status(compared()), 3);
}

TEST_F(Folders, OfOtherSizesAndOfNoPictures) {
    put("expected", 0, black);
    put("actual", 0, filled(10, 20, {0, 0, 0}));
    put_both(1, black);
    put("expected", 2, black);
    put_bytes("actual", "frame_0002.png", "no picture");
    put_both(3, black);
    const Comparison comparison = compared();
    EXPECT_EQ(comparison.frames[0].verdict, Verdict::other_size);
    EXPECT_THAT(comparison.frames[0].expected_size, ElementsAre(20, 10));
    EXPECT_THAT(comparison.frames[0].actual_size, ElementsAre(10, 20));
    EXPECT_EQ(comparison.frames[2].verdict, Verdict::unreadable);
    EXPECT_THAT(comparison.frames[2].problem, AllOf(HasSubstr("actual"), HasSubstr("PNG signature")));
    EXPECT_EQ(comparison.frames[3].verdict, Verdict::same_bytes);
    EXPECT_EQ(status(comparison), 3);
}

// A pipe would keep one waiting for ever, and is no reason to call two folders the same.
TEST_F(Folders, NameWhatIsNoFile) {
    put_both(0, black);
    put("expected", 1, black);
    ASSERT_EQ(::mkfifo((temporary.path() / "actual/frame_0001.png").c_str(), 0600), 0);
    const Comparison comparison = compared();
    EXPECT_EQ(comparison.frames[1].verdict, Verdict::unreadable);
    EXPECT_THAT(comparison.frames[1].problem, HasSubstr("frame_0001.png: is no regular file"));
    EXPECT_EQ(status(comparison), 3);
}

TEST_F(Folders, NameATruncatedFileWhereverItWasCut) {
    put("expected", 0, black);
    const auto bytes = read_file(temporary.path() / "expected" / "frame_0000.png");
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        put_bytes("actual", "frame_0000.png", {reinterpret_cast<const char*>(bytes.data()), size});
        const Comparison comparison = compared();
        EXPECT_EQ(comparison.frames[0].verdict, Verdict::unreadable) << size;
        EXPECT_EQ(status(comparison), 1) << "no frame could be compared";
    }
}

TEST_F(Folders, AreOrderedByTheNumbersInTheNames) {
    for (const char* name : {"b10.png", "b9.png", "b009.png", "a.png", "c2d1.png", "c10d0.png"})
        put_bytes("expected", name, "");
    std::vector<std::string> names;
    std::vector<long> numbers;
    for (const FrameComparison& frame : compared().frames) {
        names.push_back(frame.name);
        numbers.push_back(frame.number);
    }
    EXPECT_THAT(names, ElementsAre("a.png", "b009.png", "b9.png", "b10.png", "c2d1.png", "c10d0.png"));
    EXPECT_THAT(numbers, ElementsAre(-1, 9, 9, 10, 1, 0));
}

TEST_F(Folders, HoldOtherFilesThatAreNoFrames) {
    put_both(0, black);
    put_bytes("expected", "clip.json", "{}");
    std::filesystem::create_directory(temporary.path() / "actual" / "folder.png");
    EXPECT_THAT(verdicts(), ElementsAre(Verdict::same_bytes));
}

TEST_F(Folders, CannotBeComparedWithFilesOrNothing) {
    const auto compare_with = [&](const char* actual) {
        return [this, actual] { compare(temporary.path() / "expected", temporary.path() / actual, {}); };
    };
    EXPECT_THAT(compare_with("actual"), ThrowsMessage<std::runtime_error>(HasSubstr("neither folder holds")));
    EXPECT_THAT(compare_with("none"), ThrowsMessage<std::runtime_error>(HasSubstr("none: no such file")));
    put_bytes("actual", "a.png", "");
    EXPECT_THAT(compare_with("actual/a.png"),
                ThrowsMessage<std::runtime_error>(HasSubstr("a folder and a file")));
}

TEST_F(Folders, OrFilesOfOtherNames) {
    put("expected", 0, black);
    put("actual", 1, black);
    const Comparison comparison =
        compare(temporary.path() / "expected/frame_0000.png", temporary.path() / "actual/frame_0001.png", {});
    ASSERT_EQ(comparison.frames.size(), 1u);
    EXPECT_EQ(comparison.frames[0].verdict, Verdict::same_bytes);
}

TEST_F(Folders, HoldTheSamePixelsInOtherBytes) {
    put("expected", 0, black);
    write_file(temporary.path() / "actual/frame_0000.png", encode_png(black, {{"Comment", "another"}}));
    EXPECT_THAT(verdicts({.channel = 0, .pixels = 0}), ElementsAre(Verdict::same_pixels));
    EXPECT_EQ(status(compared()), 0);
}

}  // namespace
}  // namespace ropesim
