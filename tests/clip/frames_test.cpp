#include "clip/frames.h"

#include "clip/file.h"
#include "clip/temporary_folder.h"

#include <gmock/gmock.h>

#include <limits>

namespace ropesim {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string refusal(const std::string& text, long frames) {
    try {
        parse_frames(text, frames);
        return "";
    } catch (const std::runtime_error& error) {
        return error.what();
    }
}

TEST(FrameList, IsEachNumberOnceAndAscending) {
    EXPECT_THAT(FrameList({7, 3, 4, 3, 9, 8}), ElementsAre(3, 4, 7, 8, 9));
    EXPECT_THAT(FrameList(std::vector<FrameList::Range>{{5, 9}, {0, 2}, {6, 7}, {3, 3}}),
                ElementsAre(0, 1, 2, 3, 5, 6, 7, 8, 9));
    EXPECT_THAT(FrameList(), IsEmpty());
}

TEST(FrameList, GoesUpToTheLastNumberThereIs) {
    constexpr long last = std::numeric_limits<long>::max();
    EXPECT_EQ(FrameList({last, 3, last}).ranges(), (std::vector<FrameList::Range>{{3, 3}, {last, last}}));
}

TEST(FrameList, KnowsWhatItHolds) {
    const FrameList frames{2, 3, 5};
    EXPECT_EQ(frames.size(), 3u);
    EXPECT_EQ(frames.back(), 5);
    for (const long frame : {2, 3, 5}) EXPECT_TRUE(frames.contains(frame));
    for (const long frame : {1, 4, 6}) EXPECT_FALSE(frames.contains(frame));
}

TEST(FrameList, KeepsRangesAndNotNumbers) {
    EXPECT_EQ(parse_frames("0:4,5:9,11:", 10'000'000).ranges(),
              (std::vector<FrameList::Range>{{0, 9}, {11, 9'999'999}}));
}

TEST(ParseFrames, IncludesBothEndsOfARange) {
    EXPECT_THAT(parse_frames("2,4,6:8", 20), ElementsAre(2, 4, 6, 7, 8));
    EXPECT_THAT(parse_frames("17:", 20), ElementsAre(17, 18, 19));
    EXPECT_THAT(parse_frames(":2", 20), ElementsAre(0, 1, 2));
    EXPECT_THAT(parse_frames("", 3), ElementsAre(0, 1, 2));
}

TEST(ParseFrames, SortsAndCountsEachOnce) {
    EXPECT_THAT(parse_frames("5,1:3,2,5", 20), ElementsAre(1, 2, 3, 5));
}

TEST(ParseFrames, RefusesAFrameBeyondTheEndAndSaysWhereItIs) {
    EXPECT_THAT(refusal("20", 20), HasSubstr("frames 0 to 19"));
    EXPECT_THAT(refusal("3:25", 20), HasSubstr("frame 25"));
}

TEST(ParseFrames, RefusesWhatIsNoList) {
    for (const char* text :
         {"x", "1,,2", "5:3", "-1", "1.5", "1:2:3", "1,", " 1", "99999999999999999999", ","})
        EXPECT_THAT(refusal(text, 20), HasSubstr("such as 2,4,10:20,90:")) << text;
}

TEST(FramesToString, IsReadBackAsTheSame) {
    const FrameList frames{0, 1, 2, 5, 7, 8};
    EXPECT_EQ(to_string(frames), "0:2,5,7:8");
    EXPECT_EQ(parse_frames(to_string(frames), 9), frames);
}

TEST(ParseShard, TakesIOfN) {
    EXPECT_EQ(parse_shard("2/3").index, 2);
    EXPECT_EQ(parse_shard("2/3").count, 3);
    for (const char* text : {"3/3", "1", "1/0", "-1/3", "a/b", "1/3/", "/"})
        EXPECT_THROW(parse_shard(text), std::runtime_error) << text;
}

TEST(FrameName, HasFourDigitsOrAsManyAsTheClipNeeds) {
    EXPECT_EQ(frame_name(7, 120), "frame_0007.png");
    EXPECT_EQ(frame_name(7, 10000), "frame_0007.png");
    EXPECT_EQ(frame_name(7, 10001), "frame_00007.png");
    EXPECT_EQ(frame_name(99999, 100000), "frame_99999.png");
}

TEST(FramesIn, FindsFramesAndNothingElse) {
    const TemporaryFolder folder;
    for (const char* name : {"frame_0010.png", "frame_0002.png", "frame_.png", "frame_x.png", "frame_1.jpg",
                             "clip.json", "frame_0003.png.tmp", ".frame_0004.png"})
        write_file(folder.path() / name, std::string_view("x"));
    EXPECT_THAT(frames_in(folder.path()), ElementsAre(2, 10));
}

}  // namespace
}  // namespace ropesim
