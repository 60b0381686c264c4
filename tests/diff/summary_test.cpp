#include "diff/summary.h"

#include "diff/folders.h"

#include <gmock/gmock.h>

namespace ropesim {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

std::string ranges_of(const std::vector<long>& numbers, std::size_t most = 8) {
    std::vector<FrameComparison> frames(numbers.size());
    std::vector<const FrameComparison*> pointers;
    for (std::size_t i = 0; i < numbers.size(); ++i) {
        frames[i].number = numbers[i];
        frames[i].name = "name";
        pointers.push_back(&frames[i]);
    }
    return ranges(pointers, most);
}

TEST(Ranges, ArePutTogetherFromNeighbours) {
    EXPECT_EQ(ranges_of({}), "");
    EXPECT_EQ(ranges_of({7}), "7");
    EXPECT_EQ(ranges_of({7, 8}), "7, 8");
    EXPECT_EQ(ranges_of({12, 13, 14}), "12 to 14");
    EXPECT_EQ(ranges_of({0, 7, 20, 21, 22}), "0, 7, 20 to 22");
    EXPECT_EQ(ranges_of({-1, -1}), "name, name");
    EXPECT_EQ(ranges_of({0, 2, 4, 5, 6}, 2), "0, 2 and 3 more");
}

TEST_F(Folders, AreSummedUpInOneLineAndOneLinePerFrame) {
    const Image black = filled(20, 10, {0, 0, 0});
    Image other = black;
    set_pixel(other, 3, 4, {0, 0, 200});
    for (const long frame : {0, 1, 2}) put_both(frame, black);
    for (const long frame : {3, 4, 5}) put("expected", frame, black);
    for (const long frame : {3, 4}) put("actual", frame, other);
    const Comparison comparison = compared();
    EXPECT_EQ(headline(comparison), "3 of 6 frames differ: 3 to 5; first frame_0003.png");
    const std::string pixels =
        ": differs: 1 of 1 drawn pixels by more than 2 (0 gone, 1 new, 0 changed), most by 200 of 255; "
        "column 3, row 4\n";
    EXPECT_EQ(frame_lines(comparison), "frame_0003.png" + pixels + "frame_0004.png" + pixels +
                                           "frame_0005.png: missing: only in EXPECTED\n");
    EXPECT_EQ(frame_lines(comparison, 1), "frame_0003.png" + pixels + "and 2 more frames: 4, 5\n");
}

TEST_F(Folders, SayInWhatSenseTheyAreTheSame) {
    const Image black = filled(20, 10, {0, 0, 0});
    put_both(0, black);
    EXPECT_EQ(headline(compared()), "same: 1 frame");
    put("expected", 1, black);
    put("actual", 1, filled(20, 10, {1, 0, 0}));
    EXPECT_EQ(headline(compared()), "same: 2 frames, 1 of them only within the tolerance");
}

TEST_F(Folders, CannotBreakALineByTheirNames) {
    put_bytes("expected", "a\n\x1b[31m.png", "");
    EXPECT_EQ(frame_lines(compared()), "a\\n\\x1b[31m.png: missing: only in EXPECTED\n");
}

}  // namespace
}  // namespace ropesim
