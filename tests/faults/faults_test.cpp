// Every call that concerns what a command writes is made to fail in turn, by fault_shim; then memory, at each
// place that takes some. Whatever fails, the command either does all the same what it should, or says one
// line and leaves nothing that is half.

#include "clip/file.h"
#include "clip/temporary_folder.h"
#include "commands/program.h"
#include "scene/scene.h"

#include <gmock/gmock.h>

#include <sys/resource.h>
#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <functional>
#include <map>
#include <set>

namespace ropesim {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

#ifdef __SANITIZE_ADDRESS__
constexpr long stride = 11;  // a run takes ten times as long
#else
constexpr long stride = 1;
#endif

using Files = std::map<std::string, std::string>;
using Environment = std::map<std::string, std::string>;

std::string text_of(const std::filesystem::path& path) {
    const auto bytes = read_file(path);
    return {bytes.begin(), bytes.end()};
}

Files files_in(const std::filesystem::path& folder) {
    Files files;
    if (!std::filesystem::exists(folder)) return files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        files[entry.path().filename().string()] = text_of(entry.path());
    return files;
}

class Faults : public testing::Test {
  protected:
    void SetUp() override {
        Scene scene = parse_scene(builtin_scenes().front().toml, "seed");
        scene.frames = 2;
        scene.size = {64, 48};
        write_file(temporary.path() / "small.toml", to_toml(scene));
    }

    // Runs it with a fault; whether there was one.
    bool run_with_fault(const std::vector<std::string>& arguments, Environment environment) {
        std::filesystem::remove(mark);
        environment["LD_PRELOAD"] = ROPESIM_FAULT_SHIM;
        environment["ASAN_OPTIONS"] = "verify_asan_link_order=0:detect_leaks=0:alloc_dealloc_mismatch=0";
        environment["ROPESIM_FAULT_FOLDER"] = out.string();
        environment["ROPESIM_FAULT_MARK"] = mark.string();
        for (const auto& [name, value] : environment) ::setenv(name.c_str(), value.c_str(), 1);
        outcome = ropesim(temporary.path(), arguments);
        for (const auto& [name, value] : environment) ::unsetenv(name.c_str());
        return std::filesystem::exists(mark);
    }

    std::string names_that_differ() const {
        std::string names;
        Files found = files_in(out);
        for (const auto& [name, text] : whole)
            if (found[name] != text) names += name + " ";
        for (const auto& [name, text] : found)
            if (!whole.contains(name)) names += name + " ";
        return names;
    }

    void begin_anew() const {
        std::filesystem::remove_all(out);
        if (old.empty()) return;
        std::filesystem::create_directory(out);
        for (const auto& [name, text] : old) write_file(out / name, text);
    }

    // What it should do, undisturbed.
    void run_undisturbed(const std::vector<std::string>& arguments) {
        begin_anew();
        expected = ropesim(temporary.path(), arguments);
        whole = files_in(out);
        ASSERT_FALSE(whole.empty() && expected.out.empty()) << expected.err;
    }

    void expect_done_or_refused() const {
        if (outcome.status == expected.status) {
            EXPECT_TRUE(files_in(out) == whole) << names_that_differ();
            EXPECT_TRUE(!whole.empty() || outcome.out == expected.out) << outcome.out;
            return;
        }
        EXPECT_EQ(outcome.status, 1) << outcome.err;
        EXPECT_THAT(outcome.err, AllOf(StartsWith("ropesim: "), EndsWith("\n")));
        EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
        for (const auto& [name, text] : files_in(out)) {
            if (const auto kept = meanwhile.find(name); kept != meanwhile.end() && kept->second == text)
                continue;
            ASSERT_TRUE(whole.contains(name)) << name << " is left; " << outcome.err;
            const auto before = old.find(name);
            EXPECT_TRUE(text == whole.at(name) || (before != old.end() && text == before->second))
                << name << " is half written; " << outcome.err;
        }
    }

    // What is there decides; a folder that was seen before need not be seen again.
    void expect_all_the_same_afterwards(const std::vector<std::string>& arguments) {
        if (const Files left = files_in(out); left == whole || !left_before.insert(left).second) return;
        const Outcome again = ropesim(temporary.path(), arguments);
        EXPECT_EQ(again.status, expected.status) << again.err;
        EXPECT_TRUE(files_in(out) == whole) << names_that_differ();
    }

    void try_all(const std::vector<std::string>& arguments, const std::vector<std::string>& again) {
        run_undisturbed(arguments);
        try_calls(arguments, again);
        if (!HasFailure()) try_memory(arguments, again);
    }

    // Every call in every way.
    void try_calls(const std::vector<std::string>& arguments, const std::vector<std::string>& again) {
        long tried = 0;
        const std::map<std::string, int> kinds{{"EIO", EIO},       {"ENOSPC", ENOSPC}, {"EINTR", EINTR},
                                               {"EMFILE", EMFILE}, {"EDQUOT", EDQUOT}, {"short", 0}};
        for (const auto& [name, number] : kinds) {
            const std::string kind = number == 0 ? name : std::to_string(number);
            for (long at = 1;; at += stride) {
                begin_anew();
                if (!run_with_fault(arguments,
                                    {{"ROPESIM_FAULT_AT", std::to_string(at)}, {"ROPESIM_FAULT_KIND", kind}}))
                    break;
                SCOPED_TRACE(name + " of call " + std::to_string(at) + ", " + text_of(mark));
                ++tried;
                expect_done_or_refused();
                expect_all_the_same_afterwards(again);
                if (HasFailure()) return;
            }
        }
        EXPECT_GT(tried, 0);
        std::printf("%ld faults tried\n", tried);
    }

    // No memory, once at each place that takes some.
    void try_memory(const std::vector<std::string>& arguments, const std::vector<std::string>& again) {
        long tried = 0;
        for (long place = 1;; place += stride) {
            begin_anew();
            if (!run_with_fault(arguments, {{"ROPESIM_FAULT_PLACE", std::to_string(place)}})) break;
            SCOPED_TRACE("place " + std::to_string(place) + ", " + text_of(mark));
            ++tried;
            expect_done_or_refused();
            expect_all_the_same_afterwards(again);
            if (HasFailure()) return;
        }
        EXPECT_GT(tried, 0);
        std::printf("%ld places without memory tried\n", tried);
    }

    const TemporaryFolder temporary;
    const std::filesystem::path out = temporary.path() / "out";
    const std::filesystem::path mark = temporary.path() / "mark";
    Files old;        // what is in the folder before
    Files whole;      // and afterwards
    Files meanwhile;  // what may be left for a run that goes on from there
    std::set<Files> left_before;
    Outcome expected{};
    Outcome outcome{};
};

TEST_F(Faults, Render) {
    const std::vector<std::string> render{"render", "small.toml", "-o",     out.string(),
                                          "--jobs", "1",          "--sync", "--quiet"};
    std::vector<std::string> again = render;
    again.push_back("--resume");
    try_all(render, again);
}

TEST_F(Faults, RenderByTwoJobs) {
    const std::vector<std::string> render{"render", "small.toml", "-o",     out.string(),
                                          "--jobs", "2",          "--quiet"};
    std::vector<std::string> again = render;
    again.push_back("--resume");
    try_all(render, again);
}

TEST_F(Faults, RenderPositionsOfAFileAsSmallFrames) {
    const std::filesystem::path file = temporary.path() / "at.npy";
    ropesim(temporary.path(), {"simulate", "small.toml", "-o", file.string(), "--no-error"});
    old = {{"at.npy", text_of(file)}};
    const std::vector<std::string> render{"render",    "small.toml", "--positions", (out / "at.npy").string(),
                                          "-o",        out.string(), "--jobs",      "1",
                                          "--compact", "--quiet"};
    std::vector<std::string> again = render;
    again.push_back("--resume");
    try_all(render, again);
}

TEST_F(Faults, ResumeOverFramesThatAreThere) {
    run_undisturbed({"render", "small.toml", "-o", out.string(), "--quiet"});
    old = whole;
    old["frame_0001.png"] = "half a frame";
    const std::vector<std::string> resume{"render", "small.toml", "-o",       out.string(),
                                          "--jobs", "1",          "--resume", "--quiet"};
    try_all(resume, resume);
}

TEST_F(Faults, SimulateToCsv) {
    old = {{"a.csv", "old"}};
    const std::vector<std::string> simulate{"simulate", "small.toml", "-o", (out / "a.csv").string(),
                                            "--no-error"};
    try_all(simulate, simulate);
}

TEST_F(Faults, SimulateToNpyAndDiagnostics) {
    old = {{"a.npy", "old"}};
    const std::vector<std::string> simulate{
        "simulate",  "small.toml", "-o", (out / "a.npy").string(), "--diagnostics", (out / "b.csv").string(),
        "--no-error"};
    try_all(simulate, simulate);
}

TEST_F(Faults, SimulateToStandardOutput) {
    const std::vector<std::string> simulate{"simulate", "small.toml", "-o", "-", "--no-error"};
    try_all(simulate, simulate);
}

TEST_F(Faults, PlanThatIsWritten) {
    old = {{"a.toml", "old"}};
    const std::vector<std::string> plan{"plan", "small.toml", "--tolerance",
                                        "1",    "--write",    (out / "a.toml").string()};
    try_all(plan, plan);
}

TEST_F(Faults, DiffWithItsReports) {
    ropesim(temporary.path(), {"render", "small.toml", "-o", "a", "--quiet"});
    ropesim(temporary.path(), {"render", "small.toml", "-g", "0", "-100", "-o", "b", "--quiet"});
    old = {{"a.html", "old"}};
    const std::vector<std::string> diff{
        "diff", "a", "b", "--report", (out / "a.html").string(), "--json", (out / "a.json").string()};
    try_all(diff, diff);
    EXPECT_EQ(expected.status, 3);
}

TEST_F(Faults, Compare) {
    const std::vector<std::string> compare{"compare",    "small.toml", "-o",
                                           out.string(), "--no-error", "--quiet"};
    std::vector<std::string> again = compare;
    again.push_back("--overwrite");
    try_all(compare, again);
}

TEST_F(Faults, VerifyThatRepairs) {
    run_undisturbed({"render", "small.toml", "-o", out.string(), "--quiet"});
    old = whole;
    old.erase("frame_0001.png");
    const std::vector<std::string> repair{"verify", out.string(), "--repair", "--jobs", "1", "--quiet"};
    try_all(repair, repair);
}

TEST_F(Faults, DiffThatAccepts) {
    run_undisturbed({"render", "small.toml", "-o", out.string(), "--quiet"});
    old = whole;
    ropesim(temporary.path(), {"render", "small.toml", "--nodes", "8", "-o", "b", "--quiet"});
    const std::vector<std::string> accept{"diff", out.string(), "b", "--accept"};
    try_all(accept, accept);
}

TEST_F(Faults, Sweep) {
    std::vector<std::string> sweep{"sweep",       "small.toml", "--vary",     "mass=1,2",  "stiffness=100",
                                   "damping=0.1", "-o",         out.string(), "--no-error"};
    std::vector<std::string> again = sweep;
    sweep.push_back("--quiet");
    again.insert(again.end(), {"--quiet", "--resume"});
    for (const char* shard : {"0/2", "1/2"}) {
        std::vector<std::string> of_shard = again;
        of_shard.insert(of_shard.end(), {"--shard", shard});
        ropesim(temporary.path(), of_shard);
    }
    meanwhile = files_in(out);
    EXPECT_EQ(meanwhile.size(), 2u) << "a file for each point";
    try_all(sweep, again);
}

TEST_F(Faults, NoOpenGl) {
    run_with_fault({"render", "small.toml", "-o", out.string()}, {{"ROPESIM_FAULT_LIBRARIES", "1"}});
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, AllOf(StartsWith("ropesim: no OpenGL 3.3 context could be made"),
                                   HasSubstr("install the Debian package libosmesa6, or libegl1")));
    ::setenv("MESA_GL_VERSION_OVERRIDE", "2.1", 1);
    outcome = ropesim(temporary.path(), {"render", "small.toml", "-o", out.string(), "--jobs", "1"});
    ::unsetenv("MESA_GL_VERSION_OVERRIDE");
    EXPECT_EQ(outcome.status, 1);
    EXPECT_THAT(outcome.err, HasSubstr("makes no OpenGL 3.3 core context"));
    EXPECT_TRUE(files_in(out).empty());
}

#ifndef __SANITIZE_ADDRESS__  // which needs terabytes of addresses
TEST_F(Faults, TooFewAddressesForMesa) {
    run_undisturbed({"render", "small.toml", "-o", out.string(), "--quiet"});
    const std::vector<std::string> render{"render", "small.toml", "-o", out.string(), "--quiet"};
    std::vector<std::string> large = render;
    large.insert(large.end(), {"--size", "3840x2160"});
    long tried = 0;
    for (rlim_t megabytes = 20; megabytes < 340; megabytes += megabytes < 200 ? 60 : 4) {
        for (const auto& arguments : {render, large}) {
            begin_anew();
            outcome = ropesim(temporary.path(), arguments, megabytes << 20);
            ++tried;
            if (outcome.status == 0) continue;
            EXPECT_EQ(outcome.status, 1) << megabytes << " MB";
            EXPECT_THAT(outcome.err,
                        testing::AnyOf("ropesim: out of memory\n",
                                       AllOf(StartsWith("ropesim: no OpenGL 3.3 context could be made"),
                                             HasSubstr("it needs 300 MB of memory, and ulimit -v allows " +
                                                       std::to_string(megabytes) + " MB\n"))));
            EXPECT_EQ(std::ranges::count(outcome.err, '\n'), 1) << outcome.err;
            EXPECT_TRUE(files_in(out).empty());
        }
    }
    begin_anew();
    EXPECT_EQ(ropesim(temporary.path(), large, rlim_t{600} << 20).status, 0) << "which is enough";
    std::printf("%ld limits of memory tried\n", tried);
}
#endif

}  // namespace
}  // namespace ropesim
