#include "sweep/point_result.h"

#include "sweep/sweep_chart.h"

#include <gmock/gmock.h>

namespace ropesim {
namespace {

using testing::HasSubstr;

// A rope that hangs straight down from its pin, all springs at rest length: no force but gravity.
Sweep hanging(const std::vector<std::string>& variations) {
    const Scene scene = parse_scene(
        "[clip]\nframes = 3\n[[rope]]\nname = \"a\"\nmethod = \"stormer_verlet\"\n"
        "start = [0, 0]\nend = [0, -150]\nnodes = 4\n",
        "a.toml");
    return make_sweep(scene, variations);
}

PointResult result(const Sweep& sweep, long point) {
    const Scene scene = sweep.at(point);
    Simulation simulation(scene, Simulation::Errors::always);
    while (simulation.frame() < scene.frames - 1) simulation.advance();
    return point_result(simulation);
}

// 64 steps of Verlet, which needs the accelerations once more at the start, for each of four masses, in the
// two frames that there are to move to.
TEST(PointResult, CountsWork) {
    const PointResult found = result(hanging({"stiffness=100,1000"}), 0);
    EXPECT_NEAR(found.work, 4 * 64, 4);
    EXPECT_TRUE(found.error);
    EXPECT_FALSE(found.diverged);
    EXPECT_GT(found.largest_stretch, 0.0);
    EXPECT_LT(found.largest_stretch, 0.01);
}

TEST(PointResult, SaysWhereARopeDiverges) {
    const Sweep sweep = hanging({"stiffness=1e14"});
    const PointResult found = result(sweep, 0);
    EXPECT_EQ(found.diverged, 1);
    EXPECT_FALSE(found.error);
    EXPECT_THAT(csv_line(sweep, 0, found), HasSubstr(",1,diverged,\n"));
}

TEST(PointResult, IsWhatItsLineSays) {
    const Sweep sweep = hanging({"stiffness=100,1e14", "title='a,b',\"c\""});
    PointResult failed;
    failed.failure.append("rope 'a': a \"quoted\", comma");
    for (const auto& [point, found] :
         {std::pair{0L, result(sweep, 0)}, {2L, result(sweep, 2)}, {3L, failed}}) {
        const std::string line = csv_line(sweep, point, found);
        const auto read = parse_csv_line(sweep, point, line);
        ASSERT_TRUE(read) << line;
        EXPECT_EQ(read->diverged, found.diverged);
        EXPECT_EQ(read->failure, found.failure);
        EXPECT_EQ(read->work, found.work);
        EXPECT_EQ(csv_line(sweep, point, *read), line);
        EXPECT_FALSE(parse_csv_line(sweep, 1, line));
        EXPECT_FALSE(parse_csv_line(sweep, point, line.substr(0, line.size() / 2)));
    }
}

TEST(SweepChart, DrawsOneOrTwoKeys) {
    EXPECT_TRUE(has_chart(hanging({"mass=1,2"})));
    EXPECT_FALSE(has_chart(hanging({"mass=1"})));
    EXPECT_TRUE(has_chart(hanging({"mass=1,2", "stiffness=10,20"})));
    EXPECT_FALSE(has_chart(hanging({"mass=1,2", "stiffness=10,20", "nodes=3,4"})));
}

}  // namespace
}  // namespace ropesim
