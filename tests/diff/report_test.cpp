#include "diff/report.h"

#include "clip/file.h"
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

std::string report_of(const Comparison& comparison) {
    return to_html(comparison, cause(comparison));
}

// What the page's script reads.
nlohmann::json data_of(const std::string& page) {
    const std::string begin = "<script id=\"data\" type=\"application/json\">";
    const std::size_t from = page.find(begin) + begin.size();
    return nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from));
}

// The picture that stands in the page under this id.
std::string picture_of(const std::string& page, const std::string& id) {
    const std::string begin = "<script type=\"text/plain\" id=\"" + id + "\">";
    const std::size_t from = page.find(begin) + begin.size();
    return page.substr(from, page.find("</script>", from) - from);
}

std::string text_of(const std::filesystem::path& path) {
    const std::vector<std::uint8_t> bytes = read_file(path);
    return {bytes.begin(), bytes.end()};
}

// The examples of RFC 4648, section 10.
TEST(Base64, IsThatOfItsStandard) {
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foob"), "Zm9vYg==");
    EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
    EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
    EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(Pictured, AreAllOrTheFirstHalfAndThenEvenlySpacedOnesUpToTheLast) {
    EXPECT_THAT(pictured(3, 4), ElementsAre(0, 1, 2));
    EXPECT_THAT(pictured(4, 4), ElementsAre(0, 1, 2, 3));
    EXPECT_THAT(pictured(10, 4), ElementsAre(0, 1, 5, 9));
    EXPECT_EQ(pictured(1000, 120).size(), 120u);
    EXPECT_EQ(pictured(1000, 120).back(), 999u);
    EXPECT_EQ(pictured(0, 4).size(), 0u);
}

TEST_F(Folders, HaveTheirPicturesInTheReportWhereTheyDiffer) {
    put_both(0, black);
    put("expected", 1, black);
    put("actual", 1, white);
    put("expected", 2, black);
    const std::string page = report_of(compared());
    const nlohmann::json data = data_of(page);
    EXPECT_EQ(data["embedded"], 2);
    EXPECT_EQ(picture_of(page, data["frames"][1]["actual"]),
              base64(text_of(temporary.path() / "actual/frame_0001.png")));
    EXPECT_EQ(picture_of(page, data["frames"][2]["expected"]),
              base64(text_of(temporary.path() / "expected/frame_0002.png")));
    EXPECT_EQ(data["frames"][2]["actual"], "");
    EXPECT_FALSE(data["frames"][0].contains("expected"));
    EXPECT_EQ(data["frames"][1]["region"], (std::vector<int>{0, 0, 19, 9}));
}

TEST_F(Folders, NeedNoNetworkToBeReported) {
    put("expected", 0, black);
    put("actual", 0, white);
    const std::string page = report_of(compared());
    EXPECT_THAT(page, HasSubstr("default-src 'none'; img-src data:;"));
    EXPECT_THAT(page, Not(HasSubstr("src=\"http")));
    EXPECT_THAT(page, Not(HasSubstr("href=")));
}

TEST_F(Folders, CannotPutMarkupIntoTheReportByTheirNames) {
    const std::string name = "<!--<script>alert(1)<\\script>@PICTURES@@DATA@\"'&.png";
    put_bytes("expected", name, "");
    put("expected", 1, black);
    const std::string page = report_of(compared());
    EXPECT_THAT(page, Not(HasSubstr("alert(1)<")));
    EXPECT_THAT(page, Not(HasSubstr("<!--<script")));
    EXPECT_EQ(data_of(page)["frames"][0]["name"], name);
    EXPECT_THAT(page.substr(page.find("</style>")), HasSubstr("select(0);")) << "the page is whole";
}

TEST_F(Folders, LimitWhatAReportHolds) {
    for (long frame = 0; frame < 200; ++frame) {
        put("expected", frame, black);
        put("actual", frame, white);
    }
    const nlohmann::json data = data_of(report_of(compared()));
    EXPECT_EQ(data["embedded"], most_pictured_frames);
    EXPECT_EQ(data["frames"].size(), 200u);
    EXPECT_TRUE(data["frames"][199].contains("expected"));
}

}  // namespace
}  // namespace ropesim
