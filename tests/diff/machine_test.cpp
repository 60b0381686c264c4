#include "diff/machine.h"

#include "diff/accept.h"
#include "diff/folders.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace ropesim {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

const Image black = filled(20, 10, {0, 0, 0});
const Image white = filled(20, 10, {255, 255, 255});

TEST_F(Folders, AreReportedAsJson) {
    put_both(7, black);
    put("expected", 8, black);
    Image changed = black;
    set_pixel(changed, 3, 4, {0, 9, 0});
    put("actual", 8, changed);
    const Comparison comparison = compared();
    const auto json = nlohmann::json::parse(to_json(comparison, cause(comparison)));
    EXPECT_EQ(json["status"], 3);
    EXPECT_EQ(json["threshold"], 2);
    EXPECT_EQ(json["frames"][0]["verdict"], "same-bytes");
    EXPECT_EQ(json["frames"][1]["name"], "frame_0008.png");
    EXPECT_EQ(json["frames"][1]["number"], 8);
    EXPECT_EQ(json["frames"][1]["passes"], false);
    EXPECT_EQ(json["frames"][1]["difference"]["over"], 1);
    EXPECT_EQ(json["frames"][1]["difference"]["largest"], 9);
    EXPECT_EQ(json["frames"][1]["difference"]["region"], (std::vector<int>{3, 4, 3, 4}));
}

TEST_F(Folders, HaveHostileNamesThatStayNames) {
    const std::string name = "a\"<&>\n\x1b\xff]]>' \xed\xa0\x80.png";
    put_bytes("expected", name, "");
    const Comparison comparison = compared();
    const std::string json = to_json(comparison, cause(comparison));
    EXPECT_THAT(nlohmann::json::parse(json)["frames"][0]["name"].get<std::string>(),
                HasSubstr("a\"<&>\n\x1b\xef\xbf\xbd]]>' "));
    const std::string xml = to_junit(comparison, cause(comparison));
    EXPECT_THAT(xml, HasSubstr("name=\"a&quot;&lt;&amp;&gt;\\n\\x1b\\xff]]&gt;' \\xed\\xa0\\x80.png"));
    EXPECT_THAT(xml, Not(HasSubstr("\xff")));
    EXPECT_THAT(xml, Not(HasSubstr("\xed\xa0")));
}

TEST_F(Folders, AreReportedAsJunitWithAFailurePerFrame) {
    put_both(0, black);
    put("expected", 1, black);
    put("actual", 1, white);
    put("expected", 2, black);
    const Comparison comparison = compared();
    const std::string xml = to_junit(comparison, cause(comparison));
    EXPECT_THAT(xml, HasSubstr("<testsuite name=\"ropesim diff\" tests=\"3\" failures=\"2\">"));
    EXPECT_THAT(xml, HasSubstr("name=\"frame_0000.png\"/>"));
    EXPECT_THAT(xml, HasSubstr("<failure type=\"different\" message=\"differs: 200 of 200 drawn pixels"));
    EXPECT_THAT(xml, HasSubstr("<failure type=\"missing\""));
}

TEST_F(Folders, AreTheSameOnceAccepted) {
    put_both(0, black);
    for (const long frame : {1, 2}) put("actual", frame, white);
    put("expected", 1, black);
    EXPECT_THAT(accept(compared()).done, ElementsAre("frame_0001.png: replaced", "frame_0002.png: added"));
    EXPECT_EQ(status(compared()), 0);
    EXPECT_THAT(verdicts(), ElementsAre(Verdict::same_bytes, Verdict::same_bytes, Verdict::same_bytes));
}

TEST_F(Folders, AreNotAcceptedWhereFramesAreMissingOrBroken) {
    put("expected", 0, black);
    put("expected", 1, black);
    put_bytes("actual", "frame_0001.png", "broken");
    const Accepted accepted = accept(compared());
    EXPECT_THAT(accepted.done, ElementsAre());
    EXPECT_THAT(accepted.left, ElementsAre(HasSubstr("frame_0000.png: only in EXPECTED"),
                                           HasSubstr("frame_0001.png: ACTUAL's is no whole PNG")));
    EXPECT_THAT(verdicts(), ElementsAre(Verdict::missing, Verdict::unreadable));
}

}  // namespace
}  // namespace ropesim
