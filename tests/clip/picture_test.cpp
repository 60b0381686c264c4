#include "clip/picture.h"

#include <gtest/gtest.h>

namespace ropesim {
namespace {

TEST(MakeRenderer, NamesAsManyRopesAsALegendHolds) {
    Scene scene;
    scene.title = "Many";
    std::vector<Words> words{{"Many", {255, 255, 255}}, {"Steps per frame: 64", {255, 255, 255}}};
    for (int i = 0; i < 13; ++i) {
        SceneRope rope;
        rope.name = "rope " + std::to_string(i);
        scene.ropes.push_back(rope);
        if (i < 11) words.push_back({rope.name, rope.color});
    }
    words.push_back({"and 2 more ropes", {255, 255, 255}});
    Renderer expected(scene.size[0], scene.size[1], {scene.view.center, scene.view.height}, scene.background,
                      words);
    EXPECT_EQ(make_renderer(scene)->draw({}), expected.draw({}));
}

}  // namespace
}  // namespace ropesim
