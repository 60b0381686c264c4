#include "sweep/sweep.h"

#include <gmock/gmock.h>

#include <stdexcept>

namespace ropesim {
namespace {

using testing::ElementsAre;

Scene seed() {
    return parse_scene(builtin_scenes().front().toml, "seed");
}

TEST(Sweep, VariesTheLastKeyFastest) {
    const Sweep sweep = make_sweep(seed(), {"stiffness=50,100", "method=xpbd,stormer_verlet,blanes_moan_4"});
    EXPECT_EQ(sweep.points(), 6);
    EXPECT_THAT(sweep.values(0), ElementsAre("50", "xpbd"));
    EXPECT_THAT(sweep.values(2), ElementsAre("50", "blanes_moan_4"));
    EXPECT_THAT(sweep.values(4), ElementsAre("100", "stormer_verlet"));
    EXPECT_EQ(point_name(sweep, 4), "point_0004");
}

TEST(Sweep, SetsTheKeysOfEveryRopeOrOfOne) {
    const Sweep sweep = make_sweep(seed(), {"stiffness=50,70", "rope[Verlet].mass=2,3", "clip.frames=5,9"});
    Scene expected = seed();
    for (SceneRope& rope : expected.ropes) rope.stiffness = 70.0;
    expected.ropes[1].mass = 2.0;
    expected.frames = 9;
    EXPECT_TRUE(sweep.at(5) == expected);
}

// As the options -s and -m do, and what excludes each other in a scene file.
TEST(Sweep, ReplacesWhatAKeyExcludes) {
    Scene scene = seed();
    scene.ropes[0].steps_per_frame = 5;
    scene.ropes[0].masses.assign(16, 2.0);
    const Scene point = make_sweep(scene, {"steps_per_frame=7", "mass=3", "damping=0.25"}).at(0);
    EXPECT_EQ(steps_per_frame(point, point.ropes[0]), 7);
    EXPECT_EQ(point.ropes[0].mass, 3.0);
    EXPECT_TRUE(point.ropes[0].masses.empty());
    EXPECT_EQ(point.ropes[1].damping, 0.25);
    EXPECT_EQ(point.ropes[1].damping_factor, 0.0);
    EXPECT_NO_THROW(check_scene(point));
}

TEST(Sweep, RefusesAKeyThatIsVariedTwiceAndTooManyPoints) {
    EXPECT_THROW(make_sweep(seed(), {"mass=1,2", "mass=3,4"}), std::runtime_error);
    EXPECT_THROW(make_sweep(seed(), {"mass=1:2:1000", "stiffness=1:2:1000"}), std::runtime_error);
}

}  // namespace
}  // namespace ropesim
