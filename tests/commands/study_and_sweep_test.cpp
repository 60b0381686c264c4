// The commands that run a scene many times: study, plan, sweep, submit.
#include "commands/command_line.h"

#include "clip/manifest.h"

namespace ropesim {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;

TEST_F(CommandLine, StudyLeavesNumbersAndChartsWithTheirScripts) {
    const Outcome outcome = run({"study", "work-precision", "--frames", "4", "--nodes", "3", "--methods",
                                 "stormer_verlet,explicit_euler,odeint:velocity_verlet", "-o", "charts"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.err, IsEmpty());
    EXPECT_THAT(outcome.out, HasSubstr("work_precision.csv in charts"));
    for (const char* chart : {"work_precision", "work_count"}) {
        EXPECT_GT(picture(std::string("charts/") + chart + ".png").width, 1000);
        EXPECT_TRUE(exists(std::string("charts/") + chart + ".svg"));
        EXPECT_TRUE(exists(std::string("charts/") + chart + ".gp"));
    }
}

TEST_F(CommandLine, StudyRefusesWhatItCannotStudy) {
    const auto refused = [&](std::vector<std::string> more, const std::string& message) {
        std::vector<std::string> arguments{"study", "work-precision"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        expect_failure(arguments, 1, message);
        EXPECT_FALSE(exists("study"));
    };
    refused({"--methods", "leapfrog"}, "unknown method 'leapfrog'");
    refused({"--rope", "Heun"}, "no rope 'Heun' in the scene; expected one of: 'Euler', 'Verlet'");
    refused({"--frames", "1"}, "expected 2 frames or more");
    refused({"--frames", "0"}, "frames");
}

TEST_F(CommandLine, PlanSavesASceneThatKeepsToTheTolerance) {
    const Outcome outcome = run({"plan", "seed", "--tolerance", "0.01", "--write", "planned.toml"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.out,
                AllOf(HasSubstr("rope 'Euler': 16 masses, 120 frames, at most 0.01 px"), HasSubstr("take "),
                      HasSubstr("as written  symplectic_euler, 64 steps"), HasSubstr("runner-up "),
                      HasSubstr("looser "), HasSubstr("a disturbance of 1e-9 px grows to")));
    const Outcome truth = run({"simulate", "planned.toml", "--truth", "truth.csv"});
    EXPECT_EQ(truth.status, 0) << truth.err;
    EXPECT_THAT(truth.err, HasSubstr("rope 'Euler'"));
    const double worst = std::stod(truth.err.substr(truth.err.find("off by ") + 7));
    EXPECT_LE(worst, 0.01);
}

TEST_F(CommandLine, PlanSaysWhatCanBeKeptWhereTheToleranceCannot) {
    const Outcome outcome = run({"plan", "seed", "--tolerance", "1e-9", "--write", "planned.toml"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.out, HasSubstr("nothing keeps to it; the nearest is"));
    EXPECT_THAT(outcome.err, HasSubstr("the tolerance cannot be kept; nothing was written"));
    EXPECT_FALSE(exists("planned.toml"));
    expect_failure({"plan", "--tolerance", "0"}, 2, "--tolerance");
    expect_failure({"plan", "--tolerance", "-1"}, 2, "--tolerance");
    expect_failure({"plan", "--tolerance", "nan"}, 2, "--tolerance");
}

// The frames carry the scene as planned, so that they render again to the same bytes without planning.
TEST_F(CommandLine, RendersAnAutomaticRopeByWhatItPlans) {
    write("auto.toml",
          "[clip]\nframes = 20\ntolerance = 0.01\n[[rope]]\nname = \"a\"\nmethod = \"auto\"\n"
          "start = [0, 200]\nend = [-400, 200]\n");
    EXPECT_EQ(run({"auto.toml"}).status, 2);
    const Outcome outcome = run({"render", "auto.toml", "--frames", "0,19"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("rope 'a': planned "));
    EXPECT_EQ(run({"render", "frames/frame_0019.png", "--frames", "0,19", "-o", "again"}).status, 0);
    EXPECT_EQ(contents("again"), contents("frames"));
    const auto scene =
        scene_of(decode_png_texts(read_file(temporary.path() / "frames/frame_0019.png"), ""), "");
    EXPECT_NE(scene.ropes[0].method, "auto");
    EXPECT_TRUE(scene.ropes[0].steps_per_frame);
}

// A sweep of two keys where one method cannot move the rope and another diverges.
TEST_F(CommandLine, SweepGivesTheSameTableByAnyNumberOfJobsAndShards) {
    write("small.toml", small_seed());
    const std::vector<std::string> grid{"sweep",
                                        "small.toml",
                                        "--vary",
                                        "method=stormer_verlet,xpbd",
                                        "stiffness=10,100,1e9",
                                        "pinned=[0],[15],[0,0]",
                                        "--clips"};
    const auto swept = [&](std::vector<std::string> more) {
        more.insert(more.begin(), grid.begin(), grid.end());
        return run(more);
    };
    const Outcome one = swept({"-o", "one"});
    EXPECT_EQ(one.status, 0) << one.err;
    EXPECT_EQ(one.out, "18 points, 2 diverged, 6 failed: sweep.csv, sheet.png in one\n");
    EXPECT_EQ(swept({"-o", "two", "--jobs", "2"}).status, 0);
    for (const char* shard : {"2/3", "0/3", "1/3"})
        EXPECT_EQ(swept({"-o", "three", "--shard", shard}).status, 0);
    EXPECT_FALSE(exists("three/sweep.csv"));
    EXPECT_EQ(swept({"-o", "three", "--resume"}).status, 0);
    for (const std::string folder : {"two/", "three/"}) {
        for (const std::string file : {"sweep.csv", "sheet.png", "point_0004/frame_0004.png"})
            EXPECT_EQ(read_file(temporary.path() / (folder + file)),
                      read_file(temporary.path() / ("one/" + file)));
    }
    const Outcome again = swept({"-o", "one"});
    EXPECT_EQ(again.status, 1);
    EXPECT_THAT(again.err, HasSubstr("one already holds a sweep"));
}

// tests/farm/farm_test submits to a real Slurm.
TEST_F(CommandLine, SubmitPrintsWhatItWouldHandOver) {
    write("small.toml", small_seed());
    const Outcome outcome =
        run({"submit", "small.toml", "-s", "16", "-o", "clip", "--shards", "4", "--dry-run"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.out,
                AllOf(HasSubstr("#SBATCH --array=0-3\n"), HasSubstr("--shard \"$SLURM_ARRAY_TASK_ID/4\""),
                      HasSubstr("verify "), HasSubstr("$ sbatch --parsable render.sh\n")));
    EXPECT_THAT(outcome.err, HasSubstr("simulating is "));
    const Outcome grid = run({"sweep", "small.toml", "--vary", "mass=1:2:5", "-o", "grid", "--submit",
                              "--shards", "2", "--dry-run"});
    EXPECT_EQ(grid.status, 0) << grid.err;
    EXPECT_THAT(grid.out, HasSubstr("--vary 'mass=1:2:5' -o "));
    EXPECT_FALSE(exists("clip"));
    EXPECT_FALSE(exists("grid"));
    expect_failure({"submit", "-s", "0", "--shards", "4", "-o", "frames"}, 1, "steps_per_frame");
    expect_failure({"submit", "--shards", "0", "-o", "frames"}, 2, "--shards");
    expect_failure({"submit", "--shards", "4", "--partition", "a b", "-o", "frames"}, 2, "--partition");
    expect_failure({"sweep", "--vary", "mass=1,2", "--shards", "4", "-o", "frames"}, 2, "--submit");
}

TEST_F(CommandLine, SweepDrawsAChartOfOneOrTwoKeys) {
    for (const std::string second : {"stiffness=100", "stiffness=10,100"}) {
        const Outcome outcome =
            run({"sweep", "--vary", "steps_per_frame=4,64", second, "clip.frames=3", "-o", second});
        EXPECT_EQ(outcome.status, 0) << outcome.err;
    }
    EXPECT_EQ(run({"sweep", "--vary", "steps_per_frame=4,64", "-o", "one"}).status, 0);
    EXPECT_EQ(run({"sweep", "--vary", "steps_per_frame=4,64", "method=xpbd,auto", "-o", "two"}).status, 0);
    for (const std::string folder : {"one", "two"}) {
        EXPECT_GE(picture(folder + "/sweep.png").width, 1000);
        EXPECT_TRUE(exists(folder + "/sweep.svg"));
        EXPECT_TRUE(exists(folder + "/sweep.gp"));
    }
}

TEST_F(CommandLine, SweepRefusesWhatItCannotVary) {
    expect_failure({"sweep", "-o", "frames"}, 2, "--vary is required");
    expect_failure({"sweep", "--vary", "stifness=1:2:3", "-o", "frames"}, 2, "did you mean 'stiffness'?");
    expect_failure({"sweep", "--vary", "mass=1,2", "--frames", "3", "-o", "frames"}, 2, "--clips");
    expect_failure({"sweep", "--vary", "mass=1,2", "--clips", "--sheet-frame", "120", "-o", "frames"}, 2,
                   "--sheet-frame: found 120, expected 0 to 119");
}

}  // namespace
}  // namespace ropesim
