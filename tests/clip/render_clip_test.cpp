#include "clip/render_clip.h"

#include "clip/digest.h"
#include "clip/file.h"
#include "clip/find_scene.h"
#include "clip/interrupt.h"
#include "clip/manifest.h"
#include "clip/temporary_folder.h"
#include "image/png.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <csignal>
#include <map>
#include <tuple>

namespace ropesim {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Bytes = std::vector<std::uint8_t>;

Scene small_scene() {
    Scene scene = parse_scene(builtin_scenes().front().toml, "seed");
    scene.size = {160, 120};
    scene.frames = 12;
    return scene;
}

ClipOptions into(const std::filesystem::path& folder, const Scene& scene) {
    ClipOptions options;
    options.folder = folder;
    options.frames = parse_frames("", scene.frames);
    return options;
}

ClipResult render(const Scene& scene, const ClipOptions& options) {
    Simulation simulation(scene, Simulation::Errors::estimated);
    const FolderLock lock = prepare_folder(scene, options);
    return render_clip(scene, simulation, nullptr, options);
}

std::map<std::string, Bytes> contents(const std::filesystem::path& folder) {
    std::map<std::string, Bytes> files;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        files[entry.path().filename().string()] = read_file(entry.path());
    return files;
}

class RenderClip : public testing::Test {
  protected:
    const Scene scene = small_scene();
    const TemporaryFolder temporary;
    const std::filesystem::path folder = temporary.path() / "frames";
    const std::filesystem::path other = temporary.path() / "other";
};

TEST_F(RenderClip, MakesEveryFrameAndTheManifest) {
    const ClipResult result = render(scene, into(folder, scene));
    EXPECT_EQ(result.written, 12);
    EXPECT_THAT(frames_in(folder), ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11));
    EXPECT_EQ(contents(folder).size(), 13u);
    const Bytes json = read_file(folder / "clip.json");
    const auto manifest = nlohmann::json::parse(json.begin(), json.end());
    EXPECT_EQ(manifest["frames"], "0:11");
    EXPECT_EQ(manifest["ropes"][1]["method"], "seed_verlet");
    const nlohmann::json& energy = manifest["ropes"][0]["energy"];
    EXPECT_EQ(energy["first"]["kinetic"], 0.0);
    EXPECT_GT(energy["last"]["kinetic"], 0.0);
    double drift = 0.0;
    for (const char* kind : {"kinetic", "spring", "gravity"})
        drift += energy["last"][kind].get<double>() - energy["first"][kind].get<double>();
    EXPECT_NEAR(manifest["ropes"][0]["energy_drift"].get<double>(), drift, 1e-9);
    EXPECT_EQ(parse_scene(manifest["scene"].get<std::string>(), "manifest"), scene);
}

TEST_F(RenderClip, GivesTheSameBytesByAnyNumberOfJobs) {
    render(scene, into(folder, scene));
    for (const int jobs : {2, 3, 20}) {
        ClipOptions by_jobs = into(other, scene);
        by_jobs.jobs = jobs;
        by_jobs.existing = Existing::overwrite;
        EXPECT_EQ(render(scene, by_jobs).written, 12);
        EXPECT_EQ(contents(folder), contents(other)) << jobs;
    }
}

TEST_F(RenderClip, GivesTheSamePicturesInCompactFiles) {
    render(scene, into(folder, scene));
    ClipOptions compact = into(other, scene);
    compact.compact = true;
    render(scene, compact);
    for (const std::string name : {"frame_0000.png", "frame_0011.png"}) {
        const Bytes fast = read_file(folder / name);
        const Bytes small = read_file(other / name);
        EXPECT_LT(small.size(), fast.size());
        EXPECT_EQ(decode_png(small, name), decode_png(fast, name));
        EXPECT_EQ(decode_png_texts(small, name), decode_png_texts(fast, name));
    }
}

TEST_F(RenderClip, SaysThatAJobFailed) {
    ClipOptions two_jobs = into(folder, scene);
    two_jobs.jobs = 2;
    Simulation simulation(scene, Simulation::Errors::estimated);
    const FolderLock lock = prepare_folder(scene, two_jobs);
    std::filesystem::create_directory(folder / "frame_0000.png");  // where nothing can be renamed to
    std::filesystem::create_directory(folder / "frame_0000.png" / "occupied");
    EXPECT_THROW(render_clip(scene, simulation, nullptr, two_jobs), std::runtime_error);
    EXPECT_FALSE(std::filesystem::exists(folder / "clip.json"));
}

TEST_F(RenderClip, GivesTheSameFolderByShards) {
    render(scene, into(folder, scene));
    for (const long index : {2, 0, 1}) {
        ClipOptions shard = into(other, scene);
        shard.shard = {index, 3};
        EXPECT_EQ(render(scene, shard).written, 4);
    }
    EXPECT_EQ(contents(folder), contents(other));
}

TEST_F(RenderClip, IsMadeAgainFromOneOfItsFrames) {
    render(scene, into(folder, scene));
    const Scene found = find_scene((folder / "frame_0007.png").string()).scene;
    EXPECT_EQ(found, scene);
    render(found, into(other, found));
    EXPECT_EQ(contents(folder), contents(other));
}

TEST_F(RenderClip, RefusesAFolderThatHoldsFrames) {
    write_file(temporary.path() / "frame_0003.png", std::string_view("of something else"));
    try {
        const FolderLock lock = prepare_folder(scene, into(temporary.path(), scene));
        FAIL();
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), HasSubstr("already holds frames (3); --resume keeps those of this clip"));
    }
    EXPECT_EQ(contents(temporary.path()).size(), 1u);
}

TEST_F(RenderClip, KeepsOthersOutOfItsFolder) {
    ClipOptions options = into(folder, scene);
    std::optional<FolderLock> lock = prepare_folder(scene, options);
    options.shard = {1, 2};
    EXPECT_THROW(std::ignore = prepare_folder(scene, options), std::runtime_error)
        << "a shard, into a whole render";
    lock.reset();
    lock.emplace(prepare_folder(scene, options));
    options.shard = {0, 2};
    { const FolderLock of_a_shard = prepare_folder(scene, options); }
    Scene changed = scene;
    changed.gravity[1] = -2.0;
    EXPECT_THROW(std::ignore = prepare_folder(changed, options), std::runtime_error) << "of another clip";
    try {
        std::ignore = prepare_folder(scene, into(folder, scene));
        FAIL() << "a whole render, beside a shard";
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), HasSubstr("another ropesim is writing there"));
    }
}

TEST_F(RenderClip, NeedsTheParentOfItsFolder) {
    EXPECT_THROW(std::ignore = prepare_folder(scene, into(folder / "deeper", scene)), std::runtime_error);
    EXPECT_FALSE(std::filesystem::exists(folder));
}

TEST_F(RenderClip, NeedsAFolderAndNotAFile) {
    write_file(folder, std::string_view("a file"));
    try {
        std::ignore = prepare_folder(scene, into(folder, scene));
        FAIL() << "took a file";
    } catch (const std::runtime_error& error) {
        EXPECT_THAT(error.what(), HasSubstr("is no folder; expected one, or nothing of that name"));
    }
}

TEST_F(RenderClip, ResumeMakesOnlyWhatIsNotThereWholeOrIsOfAnotherScene) {
    render(scene, into(folder, scene));
    const auto undisturbed = contents(folder);
    const auto age = [&](const char* name) { return std::filesystem::last_write_time(folder / name); };
    const auto kept_since = age("frame_0000.png");
    Scene changed = scene;
    changed.gravity[1] = -2.0;
    ClipOptions three_of_another = into(folder, changed);
    three_of_another.frames = {3};
    three_of_another.existing = Existing::overwrite;
    render(changed, three_of_another);
    std::filesystem::remove(folder / "frame_0004.png");
    std::filesystem::resize_file(folder / "frame_0005.png", undisturbed.at("frame_0005.png").size() - 1);
    std::filesystem::copy_file(folder / "frame_0007.png", folder / "frame_0006.png",
                               std::filesystem::copy_options::overwrite_existing);

    ClipOptions resume = into(folder, scene);
    resume.existing = Existing::resume;
    const ClipResult result = render(scene, resume);
    EXPECT_EQ(result.written, 4) << "3: another scene's, 4: gone, 5: cut off, 6: another frame";
    EXPECT_EQ(result.kept, 8);
    EXPECT_EQ(contents(folder), undisturbed);
    EXPECT_EQ(age("frame_0000.png"), kept_since);
}

TEST_F(RenderClip, NamesFramesBeyondItsEnd) {
    render(scene, into(folder, scene));
    Scene shorter = scene;
    shorter.frames = 9;
    ClipOptions options = into(folder, shorter);
    options.existing = Existing::overwrite;
    EXPECT_THAT(render(shorter, options).notes, ElementsAre(HasSubstr("0 to 8: 9:11")));
    EXPECT_THAT(render(scene,
                       [&] {
                           ClipOptions all = into(other, scene);
                           return all;
                       }())
                    .notes,
                IsEmpty());
}

TEST_F(RenderClip, StopsBetweenFramesAtASignal) {
    const Interrupts interrupts;
    std::raise(SIGTERM);
    try {
        render(scene, into(folder, scene));
        FAIL();
    } catch (const Interrupted& interrupted) {
        EXPECT_EQ(interrupted.signal, SIGTERM);
    }
    EXPECT_THAT(frames_in(folder), IsEmpty());
}

TEST_F(RenderClip, KeepsADivergenceInTheManifest) {
    Scene unstable = scene;
    unstable.steps_per_frame = 8;
    unstable.frames = 60;
    ClipOptions options = into(folder, unstable);
    options.frames = {59};
    render(unstable, options);
    const Bytes json = read_file(folder / "clip.json");
    const auto manifest = nlohmann::json::parse(json.begin(), json.end());
    EXPECT_LT(manifest["ropes"][0]["diverged_in_frame"], 60);
    EXPECT_THAT(manifest["ropes"][0]["divergence"].get<std::string>(), HasSubstr("10 or more are stable"));
}

TEST_F(RenderClip, FramesCarryWhatMadeThem) {
    render(scene, into(folder, scene));
    const Texts texts = decode_png_texts(read_file(folder / "frame_0007.png"), "frame");
    EXPECT_EQ(texts.at("Software"), version());
    EXPECT_EQ(texts.at("ropesim:frame"), "7");
    EXPECT_EQ(texts.at("ropesim:methods"), "Euler: symplectic_euler\nVerlet: seed_verlet");
    EXPECT_EQ(texts.at("ropesim:scene"), to_toml(scene));
    EXPECT_EQ(texts.at("ropesim:digest"), digest(to_toml(scene)));
}

}  // namespace
}  // namespace ropesim
