#include "diff/cause.h"

#include "clip/file.h"
#include "clip/frames.h"
#include "clip/manifest.h"
#include "clip/picture.h"
#include "clip/run.h"
#include "diff/folders.h"
#include "diff/predictable.h"
#include "image/png.h"

#include <gmock/gmock.h>

#include <sys/stat.h>

#include <algorithm>
#include <cmath>

namespace ropesim {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

// A rope of which all masses fall freely, x = x0, y = y0 - t^2/2: it has no pin.
constexpr const char* falling = R"(
[clip]
frames = 6
steps_per_frame = 16
size = [120, 80]
words = false
view = { center = [0.0, 0.0], height = 40.0 }
[[rope]]
name = "falling"
method = "stormer_verlet"
start = [-20.0, 10.0]
end = [20.0, 10.0]
nodes = 5
pinned = []
)";

class Causes : public Folders {
  protected:
    // Draws the frames of a scene into one of the folders, "expected" or "actual".
    void render(const char* folder, const Scene& scene, const Positions& positions) {
        const std::unique_ptr<Renderer> renderer = make_renderer(scene);
        Texts texts = frame_texts(scene, "");
        for (const auto& [frame, ropes] : positions) {
            set_frame(texts, frame);
            write_file(temporary.path() / folder / frame_name(frame, scene.frames),
                       encode_png(renderer->draw(polylines(scene, ropes)), texts));
        }
    }

    Positions simulated(const Scene& scene) const {
        return positions(simulate(scene, runs(scene)), parse_frames("", scene.frames));
    }

    void render(const char* folder, const Scene& scene) { render(folder, scene, simulated(scene)); }

    void put_positions(const char* folder, const Scene& scene, const Positions& positions) {
        put_bytes(folder, "positions.csv", to_csv(scene, positions));
    }

    Cause found() const { return cause(compared()); }

    const Scene fall = parse_scene(falling, "falling");
};

TEST_F(Causes, AreNoneOfTheSameFrames) {
    render("expected", fall);
    render("actual", fall);
    EXPECT_THAT(found().kinds, IsEmpty());
}

TEST_F(Causes, NameTheKeyAndHowFarTheMassesMoved) {
    Scene heavier = fall;
    heavier.gravity = {0.0, -2.0};
    render("expected", fall);
    render("actual", heavier);
    const Cause cause = found();
    EXPECT_THAT(cause.kinds, ElementsAre("scene", "motion"));
    ASSERT_EQ(cause.keys.size(), 1u);
    EXPECT_EQ(to_string(cause.keys[0]), "gravity [0.0, -1.0] -> [0.0, -2.0]");
    // t^2/2 world units at 2 pixels each.
    EXPECT_EQ(cause.motion.first->frame, 1);
    EXPECT_NEAR(cause.motion.first->distance, 1.0, 1e-12);
    EXPECT_EQ(cause.motion.farthest->frame, 5);
    EXPECT_NEAR(cause.motion.farthest->distance, 25.0, 1e-12);
}

TEST_F(Causes, AreTheDrawingWhereAColourIsWrong) {
    Scene red = fall;
    red.ropes[0].color = {255, 0, 0};
    render("expected", fall);
    render("actual", red);
    const Cause cause = found();
    EXPECT_THAT(cause.kinds, ElementsAre("scene", "drawing", "color"));
    EXPECT_THAT(cause.sentences, Contains(HasSubstr("every mass is where it was, to the last bit")));
    EXPECT_FALSE(cause.motion.first);
}

TEST_F(Causes, AreTheDrawingWhereALinkIsMissing) {
    Positions positions = simulated(fall);
    render("expected", fall, positions);
    Scene cut = fall;
    cut.ropes.push_back(cut.ropes[0]);
    cut.ropes[1].name = "end";
    for (auto& [frame, ropes] : positions) {
        if (frame == 3) ropes = {ropes[0].topRows(3), ropes[0].bottomRows(2)};
    }
    render("actual", fall);
    const Image image = make_renderer(cut)->draw(polylines(cut, positions.at(3)));
    write_file(temporary.path() / "actual/frame_0003.png", encode_png(image, frame_texts(fall, "")));
    EXPECT_THAT(verdicts(), ElementsAre(Verdict::same_bytes, Verdict::same_bytes, Verdict::same_bytes,
                                        Verdict::different, Verdict::same_bytes, Verdict::same_bytes));
    EXPECT_THAT(found().kinds, ElementsAre("unknown", "less")) << "the scene is the same";
    const Positions drawn = simulated(fall);
    put_positions("expected", fall, drawn);
    put_positions("actual", fall, drawn);
    const Cause cause = found();
    EXPECT_THAT(cause.kinds, ElementsAre("drawing", "less"));
    EXPECT_THAT(cause.frames, ElementsAre(testing::Pair("frame_0003.png", "drawing")));
}

TEST_F(Causes, NameAMassThatMovedByAQuarterPixel) {
    Positions positions = simulated(fall);
    render("expected", fall, positions);
    put_positions("expected", fall, positions);
    positions.at(2)[0](3, 1) += 0.125;
    render("actual", fall, positions);
    put_positions("actual", fall, positions);
    const Cause cause = found();
    EXPECT_THAT(cause.kinds, ElementsAre("motion"));
    EXPECT_THAT(cause.sentences,
                ElementsAre(HasSubstr("first in frame 2, mass 3 of rope 'falling', by 0.25 px")));
    EXPECT_THAT(cause.frames, ElementsAre(testing::Pair("frame_0002.png", "motion")));
}

TEST_F(Causes, AreTheDrawingWhereMoreChangedThanAMassesWay) {
    Positions positions = simulated(fall);
    render("expected", fall, positions);
    put_positions("expected", fall, positions);
    positions.at(2)[0](3, 1) += 1e-6;
    Scene thick = fall;
    thick.ropes[0].line_width += 1.0;
    render("actual", thick, positions);
    put_positions("actual", fall, positions);
    const Cause cause = found();
    EXPECT_THAT(cause.kinds, AllOf(Contains("motion"), Contains("drawing")));
    EXPECT_EQ(cause.frames.at("frame_0001.png"), "drawing");
    EXPECT_EQ(cause.frames.at("frame_0002.png"), "motion and drawing");
}

TEST_F(Causes, AreAFrameLateOrEarly) {
    const Positions positions = simulated(fall);
    Positions late;
    for (const auto& [frame, ropes] : positions) late[frame] = positions.at(std::max(0L, frame - 1));
    render("expected", fall, positions);
    render("actual", fall, late);
    EXPECT_THAT(found().kinds, ElementsAre("shift"));
    EXPECT_THAT(found().sentences, ElementsAre(HasSubstr("ACTUAL is 1 frame late")));
    render("expected", fall, late);
    render("actual", fall, positions);
    EXPECT_THAT(found().sentences, ElementsAre(HasSubstr("ACTUAL is 1 frame early")));
}

TEST_F(Causes, AreTheFileFormatWherePixelsAreTheSame) {
    render("expected", fall);
    for (const long frame : frames_in(temporary.path() / "expected")) {
        const auto name = frame_name(frame, fall.frames);
        const Image image = decode_png(read_file(temporary.path() / "expected" / name), name);
        write_file(temporary.path() / "actual" / name, encode_png(image, {}));
    }
    EXPECT_THAT(found().kinds, ElementsAre("file-format"));
    EXPECT_EQ(status(compared()), 0);
}

TEST_F(Causes, SayThatAManifestCannotBeRead) {
    put("expected", 0, filled(8, 8, {0, 0, 0}));
    put("actual", 0, filled(8, 8, {9, 9, 9}));
    put_bytes("expected", "clip.json", "{\"scene\": 3");
    EXPECT_THAT(found().sentences, Contains(HasSubstr("clip.json: holds no scene")));
}

// Nearly dependent constraints are chaotic: what is a millionth of a pixel off there is pixels off later.
TEST_F(Causes, AreChaosWhereNobodyCanPredictTheMotion) {
    const std::vector<BuiltinScene> scenes = builtin_scenes();
    Scene scene =
        parse_scene(std::ranges::find(scenes, "nearly-dependent", &BuiltinScene::name)->toml, "scene");
    scene.size = {120, 80};
    const long limit = *first_unpredictable_frame(scene);
    EXPECT_GT(limit, 20);
    ASSERT_LT(limit, scene.frames - 1);
    const Positions truth = simulated(scene);
    for (const bool early : {false, true}) {
        Positions expected{{limit - 1, truth.at(limit - 1)}, {limit + 1, truth.at(limit + 1)}};
        Positions actual = expected;
        actual.at(limit + 1)[0].row(5) += 2.0;
        if (early) actual.at(limit - 1)[0].row(5) += 2.0;
        for (const char* folder : {"expected", "actual"}) {
            const Positions& positions = folder[0] == 'e' ? expected : actual;
            render(folder, scene, positions);
            write_file(temporary.path() / folder / "positions.csv", to_csv(scene, positions));
        }
        Comparison comparison = compared();
        const Cause why = cause(comparison);
        EXPECT_THAT(why.kinds, Contains("chaos"));
        EXPECT_EQ(why.unpredictable, limit);
        excuse_chaos(why, comparison);
        EXPECT_EQ(status(comparison), early ? 3 : 0);
        EXPECT_EQ(comparison.frames.back().verdict, Verdict::chaos);
    }
}

// What takes the place of positions.csv would keep the reader for ever, or never end.
TEST_F(Causes, LookOnlyIntoRegularFiles) {
    render("expected", fall);
    Scene heavier = fall;
    heavier.gravity = {0.0, -2.0};
    render("actual", heavier);
    ASSERT_EQ(::mkfifo((temporary.path() / "actual" / "positions.csv").c_str(), 0600), 0);
    std::filesystem::create_symlink("/dev/zero", temporary.path() / "expected" / "positions.csv");
    EXPECT_THAT(found().kinds, ElementsAre("scene", "motion"));
}

TEST_F(Causes, LeaveOutTheMotionOfRopesThatWereToBePlanned) {
    render("expected", fall);
    Scene planned = fall;
    planned.ropes[0].method = auto_method;
    planned.gravity = {0.0, -2.0};
    render("actual", planned, simulated(fall));
    EXPECT_THAT(found().kinds, Contains("scene"));
    EXPECT_FALSE(found().motion.first);
}

TEST_F(Causes, NameRopesOfOtherNodes) {
    Scene finer = fall;
    finer.ropes[0].nodes = 9;
    render("expected", fall);
    render("actual", finer);
    EXPECT_THAT(found().sentences, Contains(HasSubstr("rope 'falling' has other nodes")));
}

}  // namespace
}  // namespace ropesim
