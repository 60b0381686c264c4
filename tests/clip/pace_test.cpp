#include "clip/pace.h"

#include <gtest/gtest.h>

namespace ropesim {
namespace {

TEST(Pace, KnowsOfNoHelpersBeforeItKnowsWhatFramesCost) {
    Pace pace;
    EXPECT_EQ(pace.worthwhile_helpers(1'000'000), 0);
    pace.add_frame(0.25);
    EXPECT_EQ(pace.worthwhile_helpers(1'000'000), 0);
}

TEST(Pace, GivesEachHelperTwiceAsMuchToDoAsItsStartCosts) {
    Pace pace;
    pace.add_frame(0.25);
    pace.add_frame(0.0078125);
    pace.add_frame(0.0234375);  // 1/64 on average
    EXPECT_EQ(pace.worthwhile_helpers(31), 0);
    EXPECT_EQ(pace.worthwhile_helpers(32), 1);
    EXPECT_EQ(pace.worthwhile_helpers(63), 1);
    EXPECT_EQ(pace.worthwhile_helpers(320), 10);
}

TEST(Pace, IsThatOfAProcessor) {
    EXPECT_GE(processors(), 1);
}

TEST(Pace, IsNoFasterThanWhatAContainerGrants) {
    EXPECT_EQ(granted_processors("200000 100000"), 2);
    EXPECT_EQ(granted_processors("150000 100000"), 2);
    EXPECT_EQ(granted_processors("5000 100000"), 1);
    for (const char* none : {"max 100000", "", "200000", "0 100000", "200000 0", "-1 100000", "a b"})
        EXPECT_EQ(granted_processors(none), std::nullopt) << none;
}

}  // namespace
}  // namespace ropesim
