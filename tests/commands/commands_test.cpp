#include "commands/command_line.h"

#include "clip/folder_lock.h"
#include "clip/frames.h"
#include "clip/manifest.h"
#include "simulation/method.h"

#include <sys/stat.h>

#include <algorithm>
#include <csignal>
#include <thread>

namespace ropesim {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

TEST_F(CommandLine, CompareDrawsTheSeedsEulerAgainstItsVerlet) {
    write("small.toml", small_seed());
    const Outcome outcome = run({"compare", "small.toml", "-o", "one"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.out, StartsWith("'Euler' and 'Verlet' "));
    EXPECT_EQ(run({"compare", "small.toml", "-o", "two", "--jobs", "2", "--quiet"}).status, 0);
    EXPECT_EQ(contents("one"), contents("two"));
    EXPECT_TRUE(exists("one/frame_0004.png"));
    EXPECT_TRUE(exists("one/comparison.csv"));
    EXPECT_TRUE(exists("one/comparison.png"));
    EXPECT_TRUE(exists("one/comparison.svg"));
}

TEST_F(CommandLine, CompareSaysWhichIsCloserToTheTruth) {
    const Outcome outcome = run({"compare", "seed-undamped", "--methods", "symplectic_euler,blanes_moan_6",
                                 "-s", "16", "--layout", "strip", "--frames", "0:2", "--truth", "-o", "one"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("closest to the truth: 'blanes_moan_6', "));
    EXPECT_TRUE(exists("one/strip.png"));
}

// Without damping the seed's Verlet is symplectic Euler, to rounding.
TEST_F(CommandLine, CompareCallsNoneCloserWhereAllAreAsFar) {
    const Outcome outcome = run({"compare", "seed-undamped", "--methods", "symplectic_euler,seed_verlet",
                                 "-s", "16", "--layout", "strip", "--frames", "0:2", "--truth", "-o", "one"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("all are as far from the truth"));
}

TEST_F(CommandLine, CompareRefusesWhatCannotBeCompared) {
    expect_failure({"compare", "--methods", "stormer_verlet", "-o", "frames"}, 1, "needs two runs");
    expect_failure({"compare", "--methods", "verlet,xpbd", "-o", "frames"}, 1, "unknown method 'verlet'");
    expect_failure({"compare", "--layout", "mosaic", "-o", "frames"}, 2, "mosaic");
}

TEST_F(CommandLine, WithoutACommandRendersTheBuiltInScene) {
    const Outcome outcome = run({"--size", "96x64", "--frames", "0:4"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.out, StartsWith("5 frames in frames/, "));
    EXPECT_THAT(outcome.err, IsEmpty());
    EXPECT_THAT(frames_in(temporary.path() / "frames"), ElementsAre(0, 1, 2, 3, 4));
}

TEST_F(CommandLine, EveryCommandHasHelpWithAnExample) {
    EXPECT_THAT(run({"--help"}).out, HasSubstr("Example"));
    for (const char* command : {"render", "simulate", "compare", "study", "plan", "sweep", "submit", "diff",
                                "verify", "methods", "scenes", "doctor"}) {
        const Outcome outcome = run({command, "--help"});
        EXPECT_EQ(outcome.status, 0);
        EXPECT_THAT(outcome.out, HasSubstr("Example")) << command;
        EXPECT_THAT(outcome.out, HasSubstr(std::string("ropesim ") + command)) << command;
    }
    EXPECT_EQ(run({"--version"}).out, version() + "\n");
}

TEST_F(CommandLine, VerifyNamesWhatIsNotRightAndRepairsJustThat) {
    write("small.toml", small_seed());
    run({"render", "small.toml"});
    const auto undisturbed = contents("frames");
    EXPECT_EQ(run({"verify", "frames"}).out, "5 frames in frames: all there, whole and of one clip\n");
    std::filesystem::remove(temporary.path() / "frames" / "frame_0001.png");
    write("frames/frame_0003.png", "half a frame");
    const auto age = std::filesystem::last_write_time(temporary.path() / "frames" / "frame_0000.png");
    const Outcome outcome = run({"verify", "frames"});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("frames/frame_0001.png: missing\n"),
                                   HasSubstr("frames/frame_0003.png: broken: ")));
    EXPECT_EQ(outcome.err, "ropesim: frames: 2 of 5 frames not right; --repair renders just those\n");
    EXPECT_EQ(run({"verify", "frames", "--quiet"}).out, "");
    const Outcome repaired = run({"verify", "frames", "--repair", "--jobs", "2"});
    EXPECT_EQ(repaired.status, 0) << repaired.err;
    EXPECT_THAT(repaired.out, HasSubstr("rendered 2 frames anew: 1,3\n"));
    EXPECT_EQ(contents("frames"), undisturbed);
    EXPECT_EQ(std::filesystem::last_write_time(temporary.path() / "frames" / "frame_0000.png"), age);
}

// What has a frame's name gives way to the frame, and is not written into.
TEST_F(CommandLine, RenderAndRepairReplaceWhatIsNoFrame) {
    write("small.toml", small_seed());
    run({"render", "small.toml"});
    const auto undisturbed = contents("frames");
    const std::vector<std::vector<std::string>> commands = {{"verify", "frames", "--repair"},
                                                            {"render", "small.toml", "--resume"},
                                                            {"render", "small.toml", "--overwrite"}};
    for (const auto& command : commands) {
        const std::filesystem::path frames = temporary.path() / "frames";
        for (const char* name : {"frame_0001.png", "frame_0002.png", "frame_0003.png"})
            std::filesystem::remove(frames / name);
        ASSERT_EQ(::mkfifo((frames / "frame_0001.png").c_str(), 0600), 0);
        std::filesystem::create_symlink("/dev/null", frames / "frame_0002.png");
        std::filesystem::create_symlink("/dev/full", frames / "frame_0003.png");
        const Outcome outcome = run(command);
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        EXPECT_EQ(contents("frames"), undisturbed) << command[0];
        for (const char* name : {"frame_0001.png", "frame_0002.png", "frame_0003.png"})
            EXPECT_EQ(std::filesystem::symlink_status(frames / name).type(),
                      std::filesystem::file_type::regular);
    }
    std::filesystem::create_directories(temporary.path() / "frames/frame_0004.png.d");
    std::filesystem::remove(temporary.path() / "frames/frame_0004.png");
    std::filesystem::rename(temporary.path() / "frames/frame_0004.png.d",
                            temporary.path() / "frames/frame_0004.png");
    EXPECT_EQ(run({"verify", "frames", "--repair"}).status, 1) << "a folder is left to its owner";
}

TEST_F(CommandLine, KeepsOthersOutOfTheFolderThatItWritesInto) {
    write("small.toml", small_seed());
    run({"render", "small.toml", "-o", "golden", "--quiet"});
    run({"render", "small.toml", "-g", "0", "-100", "-o", "frames", "--quiet"});
    const std::vector<std::vector<std::string>> commands = {
        {"sweep", "small.toml", "--vary", "mass=1,2", "-o", "golden"},
        {"study", "stability", "small.toml", "--methods", "seed_verlet", "-o", "golden"},
        {"study", "work-precision", "small.toml", "--methods", "seed_verlet", "-o", "golden"},
        {"diff", "golden", "frames", "--accept"}};
    const auto undisturbed = contents("golden");
    {
        const FolderLock lock(temporary.path() / "golden", "");
        for (const auto& command : commands) {
            const Outcome refused = run(command);
            EXPECT_EQ(refused.status, 1) << command[0];
            EXPECT_THAT(refused.err, HasSubstr("another ropesim is writing there"));
        }
    }
    EXPECT_EQ(contents("golden"), undisturbed);
    EXPECT_EQ(run(commands.back()).status, 0) << "what differs is accepted";
    EXPECT_NE(contents("golden"), undisturbed);
}

TEST_F(CommandLine, VerifyRepairsACompactClipCompactly) {
    write("small.toml", small_seed());
    run({"render", "small.toml", "--compact"});
    const auto undisturbed = contents("frames");
    std::filesystem::remove(temporary.path() / "frames" / "frame_0001.png");
    EXPECT_EQ(run({"verify", "frames", "--repair"}).status, 0);
    EXPECT_EQ(contents("frames"), undisturbed);
}

TEST_F(CommandLine, VerifyNeedsThePositionsThatAClipWasDrawnFrom) {
    write("small.toml", small_seed());
    run({"simulate", "small.toml", "-o", "at.npy"});
    run({"simulate", "small.toml", "-s", "65", "-o", "other.npy"});
    run({"render", "small.toml", "--positions", "at.npy"});
    const auto undisturbed = contents("frames");
    std::filesystem::remove(temporary.path() / "frames" / "frame_0001.png");
    EXPECT_THAT(run({"verify", "frames", "--repair"}).err, HasSubstr("give that file by --positions"));
    EXPECT_THAT(run({"verify", "frames", "--repair", "--positions", "other.npy"}).err,
                HasSubstr("other.npy: is not the file that frames was drawn from"));
    EXPECT_EQ(run({"verify", "frames", "--repair", "--positions", "at.npy"}).status, 0);
    EXPECT_EQ(contents("frames"), undisturbed);
}

TEST_F(CommandLine, RefusesWrongUsageWithStatus2) {
    expect_failure({"rendre"}, 2, "no command 'rendre'; did you mean 'render'?");
    expect_failure({"--sise", "3x4"}, 2, "--sise");
    expect_failure({"-s", "many"}, 2, "many");
    expect_failure({"-g", "1"}, 2, "--gravity");
    expect_failure({"--size", "12"}, 2, "--size: '12' is no size; expected WxH, such as 1280x720");
    expect_failure({"--size", " 12x+7"}, 2, "--size: ' 12x+7' is no size; expected WxH, such as 1280x720");
    expect_failure({"study", "work-precison"}, 2, "study what? expected one of work-precision, stability");
    expect_failure({"plan", "--tolerance", "abc"}, 2, "--tolerance = abc: not what this option takes");
    expect_failure({"--frames", "9:3"}, 2, "--frames: frames '9:3'");
    expect_failure({"--frames", "120"}, 2, "past the end of the clip; it has frames 0 to 119");
    expect_failure({"--shard", "3/3"}, 2, "--shard: shard '3/3'");
    expect_failure({"--jobs", "0"}, 2, "--jobs");
    expect_failure({"--resume", "--overwrite"}, 2, "--resume excludes --overwrite");
    expect_failure({"--shard", "0/2", "--video", "a.mp4"}, 2, "--video");
    expect_failure({"simulate", "-o", "a.txt"}, 2, "-o: 'a.txt' is neither .csv, .npy nor -");
    expect_failure({"simulate", "--method", "a", "b", "c"}, 2, "--method: found 3, expected one or 2");
}

TEST_F(CommandLine, RefusesBadInputWithStatus1) {
    write("a.toml", "[[rope]]\nstifness = 3\n");
    write("a.png", "\x89PNG\r\n\x1a\nbroken");
    expect_failure({"render", "a.toml"}, 1, "a.toml:2:1: unknown key 'stifness'");
    expect_failure({"render", "a.png"}, 1, "a.png: ");
    expect_failure({"render", "bridgee"}, 1,
                   "bridgee: no such file, and no built-in scene; did you mean 'bridge'?");
    expect_failure({"render", "."}, 1, ".: cannot read: Is a directory");
    expect_failure({"scenes", "sed"}, 1, "no built-in scene 'sed'; did you mean 'seed'?");
    expect_failure({"-s", "0"}, 1, "steps_per_frame");
    expect_failure({"-m", "-1"}, 1, "mass");
    expect_failure({"-g", "nan", "0"}, 1, "gravity");
    expect_failure({"--nodes", "1"}, 1, "nodes");
    expect_failure({"--size", "100000x4"}, 1, "--size: size is 100000, expected 1 to 16384");
    expect_failure({"--positions", "none.csv"}, 1, "none.csv: cannot open: No such file or directory");
    expect_failure({"simulate", "--method", "simplectic_euler"}, 1, "simplectic_euler");
    expect_failure({"-o", "missing/frames"}, 1,
                   "missing/frames: cannot make the folder: No such file or directory");
    for (const std::vector<std::string>& command : {std::vector<std::string>{"render"},
                                                    {"compare"},
                                                    {"study", "stability"},
                                                    {"sweep", "--vary", "mass=1,2"}}) {
        std::vector<std::string> arguments = command;
        arguments.insert(arguments.end(), {"-o", "a.png"});
        expect_failure(arguments, 1, "a.png: is no folder");
    }
}

TEST_F(CommandLine, SaysWhatDivergedAndThatTenStepsAreStable) {
    const Outcome eight = run({"-s", "8", "--size", "96x64", "--frames", "119"});
    EXPECT_EQ(eight.status, 0);
    EXPECT_THAT(eight.err, HasSubstr("warning: rope 'Euler' (symplectic_euler) is unstable at 8 steps per "
                                     "frame (h*omega = 2.49, limit 2): "
                                     "10 or more are stable"));
    EXPECT_THAT(eight.err, HasSubstr("rope 'Verlet' (seed_verlet) diverged in frame"));
    const Outcome ten = run({"-s", "10", "--size", "96x64", "--frames", "119", "-o", "ten"});
    EXPECT_EQ(ten.status, 0);
    EXPECT_THAT(ten.err, IsEmpty());
    EXPECT_EQ(run({"-s", "8", "--size", "96x64", "--frames", "119", "-o", "strict", "--strict"}).status, 1);
}

TEST_F(CommandLine, PositionsWrittenAndDrawnAreTheSamePictures) {
    for (const char* file : {"p.csv", "p.npy"}) {
        EXPECT_EQ(run({"simulate", "bridge", "-o", file}).status, 0);
        const std::string folder = std::string("of-") + file;
        EXPECT_EQ(run({"render", "bridge", "--positions", file, "--frames", "20,60", "-o", folder}).status,
                  0);
    }
    EXPECT_EQ(run({"render", "bridge", "--frames", "20,60"}).status, 0);
    for (const std::string frame : {"frame_0020.png", "frame_0060.png"}) {
        const Image simulated = picture("frames/" + frame);
        EXPECT_EQ(picture("of-p.csv/" + frame), simulated);
        EXPECT_EQ(picture("of-p.npy/" + frame), simulated);
    }
    const Outcome again = run({"render", "of-p.csv/frame_0020.png", "-o", "again"});
    EXPECT_EQ(again.status, 1);
    EXPECT_THAT(again.err, HasSubstr("was drawn from a positions file; give that file by --positions"));
}

TEST_F(CommandLine, WritesCsvToStandardOutput) {
    const Outcome outcome = run({"simulate", "seed-3-nodes", "-o", "-", "--frames", "0"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_THAT(outcome.out, StartsWith("frame,rope,node,x,y\n0,Euler,0,0,200\n0,Euler,1,-200,200\n"));
}

TEST_F(CommandLine, FailsWhereStandardOutputCannotBeWritten) {
    for (const std::vector<std::string>& arguments :
         std::vector<std::vector<std::string>>{{"methods"},
                                               {"scenes"},
                                               {"scenes", "seed"},
                                               {"doctor"},
                                               {"--version"},
                                               {"render", "--help"},
                                               {"render", "--size", "96x64", "--frames", "0:1"},
                                               {"simulate", "-o", "-", "--frames", "0:1"},
                                               {"simulate", "-o", "-", "--no-error"}}) {
        const Outcome outcome = ropesim_with_full_output(temporary.path(), arguments);
        EXPECT_EQ(outcome.status, 1) << arguments[0];
        EXPECT_THAT(outcome.err, AllOf(StartsWith("ropesim: "), HasSubstr("standard output: ")))
            << arguments[0];
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
    }
}

TEST_F(CommandLine, PrintsBuiltInScenesThatItReads) {
    const Outcome list = run({"scenes"});
    for (const BuiltinScene& scene : builtin_scenes()) {
        EXPECT_THAT(list.out, HasSubstr(std::string(scene.name) + " "));
        EXPECT_EQ(run({"scenes", std::string(scene.name)}).out, scene.toml);
    }
}

TEST_F(CommandLine, ListsEveryMethod) {
    const std::string list = run({"methods"}).out;
    for (const Method& method : methods()) EXPECT_THAT(list, HasSubstr(std::string(method.name) + " "));
}

TEST_F(CommandLine, DoctorNamesTheRenderer) {
    const Outcome outcome = run({"doctor"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_THAT(outcome.out, HasSubstr("llvmpipe"));
}

TEST_F(CommandLine, GoesOnAfterItWasKilled) {
    const std::vector<std::string> whole{"--size", "480x320", "-o", "undisturbed"};
    ASSERT_EQ(run(whole).status, 0);
    for (const std::string jobs : {"1", "2"}) {
        const std::string folder = "killed-" + jobs;
        const std::vector<std::string> arguments{"--size", "480x320", "-o",      folder,
                                                 "--jobs", jobs,      "--resume"};
        const pid_t process = start_ropesim(temporary.path(), arguments);
        while (!exists(folder + "/frame_0008.png")) std::this_thread::yield();
        ::kill(process, SIGKILL);
        EXPECT_EQ(wait_for(process), 128 + SIGKILL);
        EXPECT_EQ(run(arguments).status, 0);
        EXPECT_EQ(contents(folder), contents("undisturbed"));
    }
}

TEST_F(CommandLine, EndsCleanlyAtASignal) {
    for (const int signal : {SIGINT, SIGTERM}) {
        const std::string folder = "ended-" + std::to_string(signal);
        const pid_t process =
            start_ropesim(temporary.path(), {"--size", "1280x720", "-o", folder, "--jobs", "2"});
        while (!exists(folder + "/frame_0008.png")) std::this_thread::yield();
        ::kill(process, signal);
        const int status = wait_for(process);
        EXPECT_EQ(status, 128 + signal);
        EXPECT_FALSE(exists(folder + "/clip.json"));
        for (const auto& [name, bytes] : contents(folder)) EXPECT_THAT(name, StartsWith("frame_"));
    }
}

}  // namespace
}  // namespace ropesim
