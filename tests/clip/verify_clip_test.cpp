#include "clip/verify_clip.h"

#include "clip/file.h"
#include "clip/render_clip.h"
#include "clip/temporary_folder.h"
#include "image/compact_png.h"

#include <gmock/gmock.h>

#include <sys/stat.h>

namespace ropesim {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

Scene small_scene() {
    Scene scene = parse_scene(builtin_scenes().front().toml, "seed");
    scene.size = {64, 48};
    scene.frames = 12;
    return scene;
}

class VerifyClip : public testing::Test {
  protected:
    void render(const Scene& of, const FrameList& frames, Shard shard = {}) {
        ClipOptions options;
        options.folder = folder;
        options.frames = frames;
        options.shard = shard;
        options.existing = Existing::overwrite;
        Simulation simulation(of, Simulation::Errors::left_out);
        const FolderLock lock = prepare_folder(of, options);
        render_clip(of, simulation, nullptr, options);
    }

    // Each fault's frames and what is wrong with them.
    std::vector<std::string> faults() const {
        std::vector<std::string> lines;
        for (const FrameFault& fault : verify_clip(folder, 2, false).faults)
            lines.push_back(to_string(FrameList({fault.frames})) + ": " + fault.what);
        return lines;
    }

    std::filesystem::path frame(long number) const { return folder / frame_name(number, scene.frames); }

    std::string failure() const {
        try {
            verify_clip(folder, 1, false);
            return "";
        } catch (const std::runtime_error& error) {
            return error.what();
        }
    }

    const Scene scene = small_scene();
    const FrameList all = parse_frames("", scene.frames);
    const TemporaryFolder temporary;
    const std::filesystem::path folder = temporary.path() / "frames";
};

TEST_F(VerifyClip, FindsNothingWrongWithAClip) {
    render(scene, all);
    EXPECT_THAT(faults(), IsEmpty());
    EXPECT_EQ(verify_clip(folder, 1, false).manifest.frames, all);
}

TEST_F(VerifyClip, NamesWhatIsWrongWithFrames) {
    Scene other = scene;
    other.gravity[1] = -2.0;
    render(other, {6});
    const std::vector<std::uint8_t> of_another_scene = read_file(frame(6));
    render(scene, all);
    write_file(frame(6), of_another_scene);
    for (const long number : {2, 3, 4}) std::filesystem::remove(frame(number));
    std::filesystem::resize_file(frame(7), 100);
    std::filesystem::copy_file(frame(9), frame(8), std::filesystem::copy_options::overwrite_existing);
    EXPECT_THAT(faults(), ElementsAre("2:4: missing", "6: of another scene",
                                      StartsWith("7: broken: the file is cut off after 100 bytes"),
                                      "8: wrong number, it is frame '9'"));
    EXPECT_EQ(faulty_frames(verify_clip(folder, 1, false)), (FrameList{2, 3, 4, 6, 7, 8}));
}

// A pipe would keep one waiting for ever, a device would never end.
TEST_F(VerifyClip, NamesWhatIsNoFile) {
    render(scene, all);
    for (const long number : {1, 2, 3, 4, 5}) std::filesystem::remove(frame(number));
    ASSERT_EQ(::mkfifo(frame(1).c_str(), 0600), 0);
    std::filesystem::create_symlink("/dev/zero", frame(2));
    std::filesystem::create_directory(frame(3));
    std::filesystem::create_symlink(frame(4).filename(), frame(4));
    std::filesystem::create_symlink("nowhere", frame(5));
    EXPECT_THAT(faults(), ElementsAre("1:3: broken: is no regular file",
                                      "4: broken: cannot open: Too many levels of symbolic links",
                                      "5: broken: cannot open: No such file or directory"));
    std::filesystem::remove(folder / "clip.json");
    ASSERT_EQ(::mkfifo((folder / "clip.json").c_str(), 0600), 0);
    EXPECT_THAT(failure(), HasSubstr("clip.json: is no regular file"));
}

TEST_F(VerifyClip, NamesFramesOfAnotherVersionOrSize) {
    render(scene, all);
    const Image picture = decode_png(read_file(frame(2)), "frame");
    Texts texts = decode_png_texts(read_file(frame(2)), "frame");
    write_file(frame(2), encode_compact_png(filled(32, 24, {}), texts));
    set_frame(texts, 3);
    texts["Software"] = "ropesim 0.0.9";
    write_file(frame(3), encode_compact_png(picture, texts));
    EXPECT_THAT(faults(), ElementsAre("2: broken: 32x24 pixels, expected 64x48",
                                      "3: of another version, 'ropesim 0.0.9'"));
}

// Every byte that is changed is found: the checksums of PNG cover them all.
TEST_F(VerifyClip, FindsAnyByteThatChanged) {
    render(scene, {0});
    const std::vector<std::uint8_t> whole = read_file(frame(0));
    for (std::size_t i = 0; i < whole.size(); i += 7) {
        std::vector<std::uint8_t> bytes = whole;
        bytes[i] ^= 1;
        write_file(frame(0), bytes);
        EXPECT_EQ(faults().size(), 1u) << "byte " << i << " of " << whole.size();
    }
}

TEST_F(VerifyClip, KnowsTheWholeClipThoughShardsMadeIt) {
    render(scene, all, {0, 3});
    EXPECT_THAT(faults(), ElementsAre("1:2: missing", "4:5: missing", "7:8: missing", "10:11: missing"));
    render(scene, all, {1, 3});
    render(scene, all, {2, 3});
    EXPECT_THAT(faults(), IsEmpty());
}

TEST_F(VerifyClip, KnowsTheFramesOfEarlierRendersOfTheSameClip) {
    render(scene, {0, 1, 2});
    render(scene, {7});
    EXPECT_EQ(verify_clip(folder, 1, false).manifest.frames, (FrameList{0, 1, 2, 7}));
    Scene other = scene;
    other.gravity[1] = -2.0;
    render(other, {5});
    EXPECT_EQ(verify_clip(folder, 1, false).manifest.frames, FrameList{5});
    EXPECT_EQ(verify_clip(folder, 1, false).unnamed, (FrameList{0, 1, 2, 7}));
}

TEST_F(VerifyClip, SaysWhatIsWrongWithTheManifest) {
    EXPECT_THAT(failure(), HasSubstr("frames: no such folder"));
    std::filesystem::create_directory(folder);
    EXPECT_THAT(failure(), HasSubstr("clip.json: missing, no render has finished here"));
    write_file(folder / "clip.json", std::string_view("{\"scene\": "));
    EXPECT_THAT(failure(), HasSubstr("clip.json: holds no scene"));
    write_file(folder / "clip.json", std::string_view(R"({"scene": "a = 3", "digest": "0"})"));
    EXPECT_THAT(failure(), HasSubstr("clip.json:1:1: unknown key 'a'"));
    render(scene, all);
    const std::vector<std::uint8_t> bytes = read_file(folder / "clip.json");
    std::string json(bytes.begin(), bytes.end());
    json.replace(json.find("0:11"), 4, "0:12");
    write_file(folder / "clip.json", json);
    EXPECT_THAT(failure(), HasSubstr("clip.json: frame 12 is past the end of the clip"));
    json.replace(json.find("gravity = [0.0, -1.0]"), 21, "gravity = [0.0, -2.0]");
    write_file(folder / "clip.json", json);
    EXPECT_THAT(failure(), HasSubstr("clip.json: its digest is not that of its scene"));
    write_file(folder / "clip.json", std::string(2 * largest_scene + 1, ' '));
    EXPECT_THAT(failure(), HasSubstr("bytes, expected at most"));
}

TEST_F(VerifyClip, TellsOfTemporaryFilesThatNobodyIsWriting) {
    render(scene, {0});
    write_file(folder / ".ropesim-elsewhere-1.tmp", std::string_view("half a frame"));
    const Verification verification = verify_clip(folder, 1, false);
    EXPECT_THAT(verification.strays, ElementsAre(folder / ".ropesim-elsewhere-1.tmp"));
    EXPECT_THAT(fault_lines(folder, verification, 20),
                HasSubstr(".ropesim-elsewhere-1.tmp: a temporary file that no process of this machine"));
}

TEST_F(VerifyClip, HasAtMostAsManyLines) {
    render(scene, all);
    for (const long number : {1, 3, 5, 6, 8}) std::filesystem::remove(frame(number));
    const std::string lines = fault_lines("f", verify_clip(folder, 1, false), 2);
    EXPECT_EQ(lines,
              "f/frame_0001.png: missing\n"
              "f/frame_0003.png: missing\n"
              "and 3 more frames\n");
}

}  // namespace
}  // namespace ropesim
