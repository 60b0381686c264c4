#include "sweep/variation.h"

#include <gmock/gmock.h>

#include <stdexcept>

namespace ropesim {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

Scene seed() {
    return parse_scene(builtin_scenes().front().toml, "seed");
}

std::vector<std::string> values(const std::string& text) {
    return parse_variation(text, seed()).values;
}

std::string refusal(const std::string& text) {
    try {
        parse_variation(text, seed());
        return "accepted";
    } catch (const std::runtime_error& error) {
        return error.what();
    }
}

TEST(Variation, ReadsRangesAndLists) {
    EXPECT_THAT(values("damping=0:0.2:5"), ElementsAre("0", "0.05", "0.1", "0.15", "0.2"));
    EXPECT_THAT(values("stiffness=10:1000:3:log"), ElementsAre("10", "100", "1000"));
    EXPECT_THAT(values("stiffness=1:10:3:log"), ElementsAre("1", "3.162", "10"));
    EXPECT_THAT(values("mass=2:1:3"), ElementsAre("2", "1.5", "1"));
    EXPECT_THAT(values("mass=3:9:1"), ElementsAre("3"));
    EXPECT_THAT(values("method=xpbd,stormer_verlet"), ElementsAre("xpbd", "stormer_verlet"));
    EXPECT_THAT(values("gravity=[0,-1],[0,-2]"), ElementsAre("[0,-1]", "[0,-2]"));
    EXPECT_THAT(values("title='a,b',\"c:d\""), ElementsAre("'a,b'", "\"c:d\""));
}

TEST(Variation, GivesWholeNumbersToKeysThatTakeThem) {
    EXPECT_THAT(values("steps_per_frame=4:64:4"), ElementsAre("4", "24", "44", "64"));
    EXPECT_THAT(values("rope[Verlet].nodes=8:16:4"), ElementsAre("8", "11", "13", "16"));
    EXPECT_THAT(refusal("nodes=2:4:10"), HasSubstr("gives 2 twice"));
}

TEST(Variation, SaysWhatIsWrong) {
    EXPECT_THAT(refusal("stiffness"), HasSubstr("expected KEY=A:B:N or KEY=V1,V2"));
    EXPECT_THAT(refusal("=1,2"), HasSubstr("expected KEY=A:B:N"));
    EXPECT_THAT(refusal("stifness=1,2"), HasSubstr("unknown key 'stifness'; did you mean 'stiffness'?"));
    EXPECT_THAT(refusal("rope[2].mass=1,2"), HasSubstr("no 'rope[2]' in the scene; expected clip, rope[0] to "
                                                       "rope[1] or a rope by its name, rope[Euler]"));
    EXPECT_THAT(refusal("clip.mass=1,2"), HasSubstr("unknown key 'mass' in [clip]"));
    EXPECT_THAT(refusal("mass=1,-2"), HasSubstr("mass is -2, expected"));
    EXPECT_THAT(refusal("mass=1,heavy"), HasSubstr("mass: found a string, expected a number"));
    EXPECT_THAT(refusal("method=verlet"), HasSubstr("unknown method 'verlet'"));
    EXPECT_THAT(refusal("mass=1:2"), HasSubstr("is no range; expected A:B:N"));
    EXPECT_THAT(refusal("mass=1:2:x"), HasSubstr("asks for x values"));
    EXPECT_THAT(refusal("mass=0:2:3:log"), HasSubstr("has no equal ratios"));
    EXPECT_THAT(refusal("mass=1:inf:3"), HasSubstr("is no range"));
    EXPECT_THAT(refusal("mass=1,2,1"), HasSubstr("gives 1 twice"));
    EXPECT_THAT(refusal("mass=1,"), HasSubstr("found a string"));
    EXPECT_THAT(refusal("mass=1,'"), HasSubstr("is neither a value nor a word"));
    EXPECT_THAT(refusal("mass=1\nnodes=3"), HasSubstr("control character"));
}

}  // namespace
}  // namespace ropesim
