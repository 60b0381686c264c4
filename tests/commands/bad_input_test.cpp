// What is wrong or hostile is refused in one line of plain text, by an exit status, and leaves nothing
// behind.

#include "clip/file.h"
#include "clip/manifest.h"
#include "clip/process.h"
#include "clip/temporary_folder.h"
#include "commands/program.h"
#include "image/compact_png.h"
#include "scene/scene.h"
#include "scene/words.h"

#include <gmock/gmock.h>

#include <locale.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <set>
#include <sstream>

namespace ropesim {
namespace {

using testing::AnyOf;
using testing::HasSubstr;

const std::string rope = "[[rope]]\nstart = [0, 200]\nend = [-400, 200]\n";

std::string repeated(std::string_view text, int times) {
    std::string result;
    for (int i = 0; i < times; ++i) result += text;
    return result;
}

class BadInput : public testing::Test {
  protected:
    ~BadInput() override { std::printf("%ld bad inputs tried\n", tried); }

    void write(const std::string& name, std::string_view text) { write_file(temporary.path() / name, text); }

    std::set<std::string> files() const {
        std::set<std::string> names;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(temporary.path()))
            names.insert(entry.path());
        return names;
    }

    // Status 1 or 2, one line of plain text about it, nothing else said and nothing written.
    void expect_refused(const std::vector<std::string>& arguments, const std::string& words = "") {
        ++tried;
        std::string shown;
        for (const std::string& argument : arguments) shown += printable(argument) + " ";
        const std::set<std::string> before = files();
        const Outcome outcome = ropesim(temporary.path(), arguments);
        EXPECT_THAT(outcome.status, AnyOf(1, 2)) << shown << outcome.err;
        EXPECT_EQ(outcome.out, "") << shown;
        ASSERT_TRUE(outcome.err.ends_with('\n')) << shown;
        const std::string line = outcome.err.substr(0, outcome.err.size() - 1);
        EXPECT_TRUE(line.starts_with("ropesim: ") && is_plain(line)) << shown << line;
        EXPECT_THAT(line, HasSubstr(words)) << shown;
        EXPECT_EQ(files(), before) << shown;
    }

    void expect_scene_refused(const std::string& toml, const std::string& words = "") {
        write("bad.toml", toml);
        expect_refused({"render", "bad.toml"}, words.empty() ? "bad.toml:" : words);
    }

    const TemporaryFolder temporary;
    long tried = 0;
};

TEST_F(BadInput, OnTheCommandLine) {
    for (const char* number : {"nan", "inf", "-inf", "1e400", "1e308", "5e-324", "0", "-0", "-1", "", "1,5",
                               "0x", "1e3x", "\x1b[31m", "1\n2", "\xff"})
        for (const char* option : {"-m", "-s", "--nodes", "--jobs", "--shard", "--size"})
            expect_refused({"render", option, number});
    for (const char* number : {"nan", "inf", "1e400", "1e308", "", "1,5", "\x1b[31m"})
        expect_refused({"render", "-g", number, "0"});
    for (const char* list : {"-1", "120", "9:3", "1:2:3", "a", ",", "1,", "99999999999999999999", "\x1b[31m"})
        expect_refused({"render", "--frames", list}, "frame");
    for (const char* size : {"16385x1", "1x16385", "0x1", "-1x1", "99999999x1", "1x", "x1", "1x1x1", "1x1\n"})
        expect_refused({"render", "--size", size});
    for (const char* nodes : {"1", "1000001", "2147483648"}) expect_refused({"render", "--nodes", nodes});
    for (const char* steps : {"1000001", "2147483648"}) expect_refused({"render", "-s", steps});
    expect_refused({"\x1b[31m"}, "\\x1b[31m");
    expect_refused({"render", "--\x1b[31m"}, "\\x1b[31m");
    expect_refused({"render", "--no\nsuch"}, "no\\nsuch");
    expect_refused({"render", "seed", std::string(100'000, 'x')});
    expect_refused({"render", "-o", ""});
    expect_refused({"simulate", "-o", "\x1b[31m"}, "\\x1b[31m");
    expect_refused({"simulate", "--truth", "a.txt"}, "a.txt");
    expect_refused({"plan", "--tolerance", "1e400"});
    expect_refused({"diff", "a", "b", "--threshold", "256"});
    expect_refused({"diff", "\x1b[31m", "b"}, "\\x1b[31m");
}

TEST_F(BadInput, AsAPath) {
    std::filesystem::create_symlink("loop", temporary.path() / "loop");
    std::filesystem::create_directory(temporary.path() / "folder.toml");
    write("\x1b[31m\n.toml", "[[rope]]");
    write("empty", "");
    for (const std::string path : {"loop", "folder.toml", "\x1b[31m\n.toml", "empty", "", ".", "/", "none",
                                   "/dev/null", "/dev/zero", "\xff", "empty/below", "-"})
        expect_refused({"render", path});
    write_file(temporary.path() / "picture.png", encode_compact_png(filled(8, 8, {}), {}));
    expect_refused({"render", "picture.png"}, "picture.png: a picture without a scene in it");
    expect_refused({"render", repeated("x", 5000)}, "File name too long");
    expect_refused({"render", repeated("./", 3000) + "none"}, "File name too long");
    for (const std::string path : {"loop", "folder.toml", "empty", "", ".", "none", "/dev/null"}) {
        expect_refused({"render", "--positions", path});
        expect_refused({"diff", path, "none"});
    }
    for (const std::string path : {"loop", "empty", "", "none/below", "/dev/null", "/proc/none"})
        expect_refused({"render", "-o", path});
    for (const std::string path : {"none/a.csv", "loop/a.csv", "/proc/a.npy"})
        expect_refused({"simulate", "-o", path});
    std::filesystem::create_directory(temporary.path() / "folder.mp4");
    for (const char* path : {"none/a.mp4", "folder.mp4", "picture.png/a.gif"})
        expect_refused({"render", "--video", path}, path);
    for (const std::string& path : {std::string("none/a"), std::string("folder.toml"), std::string("loop/a"),
                                    std::string("picture.png/a"), repeated("x", 300)}) {
        expect_refused({"plan", "--write", path}, path);
        for (const char* report : {"--report", "--json", "--junit"})
            expect_refused({"diff", "picture.png", "picture.png", report, path}, path);
    }
}

// Of ten thousand names, a line that can be read.
TEST_F(BadInput, AsARopesName) {
    write("many.toml", repeated("[[rope]]\nstart = [0, 0]\nend = [1, 0]\n", 10'000));
    for (const char* command : {"compare", "study"}) {
        std::vector<std::string> arguments = {command, "many.toml", "--rope", "none"};
        if (arguments[0] == "study") arguments.insert(arguments.begin() + 1, "stability");
        expect_refused(arguments, "no rope 'none' in the scene");
        EXPECT_LT(ropesim(temporary.path(), arguments).err.size(), 300u);
    }
}

TEST_F(BadInput, AsAScene) {
    for (const char* number :
         {"nan", "inf", "-inf", "1e308", "1e400", "1e-400", "-1e16", "true", "\"1\"", "[]", "{}"})
        for (const char* key : {"mass", "stiffness", "rest_length", "nodes", "damping", "line_width",
                                "point_size", "sweeps", "damping_factor", "steps_per_frame"})
            expect_scene_refused(rope + key + " = " + number + "\n");
    for (const char* number : {"0.0", "-0.0", "5e-324", "-1.0"})
        for (const char* key : {"mass", "stiffness", "rest_length"})
            expect_scene_refused(rope + key + " = " + number + "\n", "bad.toml:4:");
    for (const char* number : {"0", "-1", "10000001", "9223372036854775807", "9223372036854775808"})
        expect_scene_refused("[clip]\nframes = " + std::string(number) + "\n" + rope, "bad.toml:2:");
    for (const char* pins : {"[0, 0]", "[16]", "[-17]", "[0, -16]", "[9223372036854775807]", "[0.0]"})
        expect_scene_refused(rope + "pinned = " + pins + "\n", "bad.toml:4:");
    for (const char* view : {"{ height = 0.0 }", "{ height = nan }", "{ height = 5e-324 }",
                             "{ center = [0] }", "{ center = [inf, 0] }"})
        expect_scene_refused("[clip]\nview = " + std::string(view) + "\n" + rope, "bad.toml:2:");
    expect_scene_refused(rope + "nodes = 1000000000000\n", "expected 2 to 1000000");
    expect_scene_refused(repeated(rope, 1) + "masses = [" + repeated("1,", 100'000) + "]\n",
                         "found 100000 masses for 16 nodes");
    expect_scene_refused(repeated("[[rope]]\nstart = [0, 0]\nend = [1e6, 0]\nnodes = 1000000\n", 100),
                         "expected at most 10000000");
    expect_scene_refused(repeated("[[rope]]\n", 100'001), "more than 100000 ropes");
    expect_scene_refused("[" + repeated("a.", 1'000'000) + "a]\n", "100 parts");
    expect_scene_refused("x = " + repeated("[", 1'000'000), "bad.toml:1:");
    expect_scene_refused("x = " + repeated("{a=", 1'000'000), "bad.toml:1:");
    expect_scene_refused("title = \"" + repeated("x", 201) + "\"\n" + rope, "expected at most 200");
    expect_scene_refused("title = \"\\u001b[31m\"\n" + rope, "control character");
    expect_scene_refused(rope + "name = \"a\\nb\"\n", "control character");
    expect_scene_refused(rope + "method = \"\\u001b[31m\"\n");
    expect_scene_refused(rope + "color = \"\\u001b[31m\"\n", "\\x1b[31m");
    expect_scene_refused(rope + "\"\\u001b[31m\" = 1\n", "\\x1b[31m");
    expect_scene_refused(rope + "name = \"\xff\"\n");
    expect_scene_refused("\xff\xfe[\0[\0", "bad.toml:1:");
    expect_scene_refused("\xef\xbb\xbf", "no rope");
    expect_scene_refused(std::string(1'000'000, '\0'), "bad.toml:1:");
}

TEST_F(BadInput, AsPositions) {
    const std::string header = "frame,rope,node,x,y\n";
    for (const std::string& text :
         {std::string(), std::string("\xef\xbb\xbf"), std::string("a,b\n"), header + "0",
          header + "0,Euler,0,1", header + "0,Euler,0,1,2\n", header + "-1,Euler,0,1,2\n",
          header + "120,Euler,0,1,2\n", header + "0,\x1b[31m,0,1,2\n", header + "0,Euler,0,\x1b[31m,2\n",
          header + "0,Euler,0,nan,2\n", header + "0,Euler,0,1e400,2\n", header + "0,\"Euler,0,1,2\n",
          header + "9223372036854775808,Euler,0,1,2\n", std::string("\x93NUMPY"),
          std::string("\x93NUMPY\x01\x00\xff\xff", 10), std::string("\x93NUMPY\x02\x00\x10\x00", 10)}) {
        write("bad.csv", text);
        expect_refused({"render", "--positions", "bad.csv"}, "bad.csv");
    }
}

TEST_F(BadInput, AsPictures) {
    const std::string signature("\x89PNG\r\n\x1a\n");
    for (const std::string& bytes :
         {std::string(), signature, signature + std::string("\xff\xff\xff\xff\x1b[31", 8),
          signature + std::string("\0\0\0\0\x1b[31\0\0\0\0", 12), std::string("GIF89a")}) {
        write("a.png", bytes);
        write("b.png", bytes + "b");
        expect_refused({"render", "a.png"}, "a.png");
        const Outcome outcome = ropesim(temporary.path(), {"diff", "a.png", "b.png"});
        EXPECT_EQ(outcome.status, 1);
        std::istringstream lines(outcome.out + outcome.err);
        for (std::string line; std::getline(lines, line);) EXPECT_TRUE(is_plain(line)) << line;
        ++tried;
    }
}

// What is kept whole in memory is refused, and not begun.
TEST_F(BadInput, AsMoreThanMemoryHolds) {
    write("long.toml", "[clip]\nframes = 10000000\nsteps_per_frame = 1\n" + rope + "nodes = 1000\n");
    for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
             {"plan", "long.toml", "--tolerance", "1"}, {"study", "work-precision", "long.toml"}})
        expect_refused(arguments, "1000 masses in 10000000 frames are to be kept in memory");
}

// Whatever it is called and says: it is written to the letter, and nothing is run or written elsewhere.
TEST_F(BadInput, AsAStrangersSceneThatCanOnlyMakePictures) {
    if (!is_installed("ffmpeg") || !is_installed("gnuplot")) GTEST_SKIP() << "no ffmpeg, or no gnuplot";
    Scene scene = parse_scene(rope + "nodes = 2\n" + rope, "rope");
    scene.frames = 3;
    scene.title = "../../t`touch pwned`";
    scene.ropes[0].name =
        "../../a`touch pwned`'.system('touch pwned').'\"; system(\"touch pwned\"); b=\"$(touch pwned);"
        "touch pwned #|touch pwned\\%s%n@pwned<script>{/Symbol x}";
    scene.ropes[1].name = "/tmp/pwned";
    const std::string file = "-y`touch pwned`'\"$(touch pwned).toml";
    std::filesystem::create_directories(temporary.path() / "away" / "from");
    write("away/from/" + file, to_toml(scene));
    const std::set<std::string> before = files();
    const std::string methods = "explicit_euler,symplectic_euler";
    for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
             {"render", "--video", "out/-y`touch pwned`.mp4"},
             {"simulate"},
             {"compare", "--methods", methods, "--overwrite"},
             {"compare", "--methods", methods, "--layout", "strip", "--overwrite"},
             {"study", "stability", "--methods", "explicit_euler"},
             {"study", "work-precision", "--methods", methods}}) {
        ++tried;
        std::vector<std::string> all = arguments;
        all.insert(all.end(), {"-o", all[0] == "simulate" ? "out/a.csv" : "out", "./away/from/" + file});
        const Outcome outcome = ropesim(temporary.path(), all);
        EXPECT_EQ(outcome.status, 0) << all[0] << outcome.err;
    }
    for (const std::string& made : files()) {
        const std::string name = std::filesystem::relative(made, temporary.path());
        EXPECT_TRUE(before.contains(made) || name == "out" || name.starts_with("out/")) << name;
        EXPECT_FALSE(name.find("pwned") != name.npos && !before.contains(made) &&
                     !name.ends_with("-y`touch pwned`.mp4"))
            << name;
    }
    EXPECT_FALSE(std::filesystem::exists("/tmp/pwned"));
}

class GoodInput : public testing::Test {
  protected:
    // Frame 1 of a scene, drawn small.
    std::vector<std::uint8_t> frame(const std::string& file) {
        const Outcome outcome =
            ropesim(temporary.path(), {"render", file, "--frames", "1", "-o", "frames", "--overwrite"});
        EXPECT_EQ(outcome.status, 0) << outcome.err;
        return read_file(temporary.path() / "frames" / "frame_0001.png");
    }

    void write(const std::string& name, std::string_view text) { write_file(temporary.path() / name, text); }

    const TemporaryFolder temporary;
    const std::string scene =
        "[clip]\nframes = 2\nsize = [96, 64]\n[[rope]]\nname = \"St\u00f6rmer\"\nstart = [0.5, 200]\n"
        "end = [-400, 200]\n";
};

TEST_F(GoodInput, IsTheSameWithLinesAndMarkOfOtherSystems) {
    std::string windows = "\xef\xbb\xbf";
    for (const char c : scene) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
    write("a.toml", scene);
    write("b.toml", windows);
    EXPECT_EQ(frame("a.toml"), frame("b.toml"));
}

// No code of ours leaves the C locale; this is about libraries, and proves something where there is a locale
// with a decimal comma, as in continuous integration.
TEST_F(GoodInput, IsTheSameInEveryLocale) {
    const locale_t comma = ::newlocale(LC_ALL_MASK, "de_DE.UTF-8", nullptr);
    std::printf("de_DE.UTF-8 is %s\n", comma ? "there" : "missing");
    if (comma) ::freelocale(comma);
    write("a.toml", scene);
    const auto plain = frame("a.toml");
    ::setenv("LC_ALL", "de_DE.UTF-8", 1);
    const auto german = frame("a.toml");
    ::unsetenv("LC_ALL");
    EXPECT_EQ(plain, german);
}

TEST_F(GoodInput, MayHaveAnyName) {
    write("a.toml", scene);
    const auto expected = frame("a.toml");
    for (const std::string name :
         {"-x.toml", "a b'\"$`;.toml", "\u0394\u03bb.toml", "\x1b[31m\n.toml", "\xff.toml"}) {
        write(name, scene);
        EXPECT_EQ(frame("./" + name), expected) << printable(name);
    }
    std::string far = temporary.path();
    while (far.size() + 202 < 4000) std::filesystem::create_directory(far += "/" + std::string(200, 'd'));
    write_file(far + "/a.toml", scene);
    EXPECT_EQ(frame(far + "/a.toml"), expected);
}

TEST_F(GoodInput, MayComeThroughAPipe) {
    write("a.toml", scene);
    const auto expected = frame("a.toml");
    const std::filesystem::path pipe = temporary.path() / "pipe";
    ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
    const pid_t writer = ::fork();
    if (writer == 0) {
        write_file(pipe, scene);
        ::_exit(0);
    }
    EXPECT_EQ(frame("pipe"), expected);
    EXPECT_EQ(wait_for(writer), 0);
}

TEST_F(GoodInput, KeepsItsOutputOnOneLineWhateverTheFolderIsCalled) {
    write("a.toml", scene);
    const Outcome outcome =
        ropesim(temporary.path(), {"render", "a.toml", "-o", "a\n\x1b[31m", "--no-error"});
    EXPECT_EQ(outcome.status, 0);
    EXPECT_THAT(outcome.out, testing::StartsWith("2 frames in a\\n\\x1b[31m/, "));
}

}  // namespace
}  // namespace ropesim
