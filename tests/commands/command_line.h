#pragma once

#include "clip/file.h"
#include "clip/temporary_folder.h"
#include "commands/program.h"
#include "image/png.h"
#include "scene/scene.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <map>
#include <string>
#include <vector>

namespace ropesim {

// Runs ropesim in a folder of its own, and looks at what it leaves there.
class CommandLine : public testing::Test {
  protected:
    Outcome run(const std::vector<std::string>& arguments) { return ropesim(temporary.path(), arguments); }

    std::map<std::string, std::vector<std::uint8_t>> contents(const std::string& folder) {
        std::map<std::string, std::vector<std::uint8_t>> files;
        for (const auto& entry : std::filesystem::directory_iterator(temporary.path() / folder))
            files[entry.path().filename().string()] = read_file(entry.path());
        return files;
    }

    bool exists(const std::string& name) { return std::filesystem::exists(temporary.path() / name); }

    Image picture(const std::string& name) { return decode_png(read_file(temporary.path() / name), name); }

    void write(const std::string& name, std::string_view text) { write_file(temporary.path() / name, text); }

    // One line on stderr that says this, the exit status, and no folder of frames.
    void expect_failure(const std::vector<std::string>& arguments, int status, const std::string& message) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.status, status) << outcome.err;
        EXPECT_THAT(outcome.err,
                    testing::AllOf(testing::StartsWith("ropesim: "), testing::HasSubstr(message)));
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
        EXPECT_FALSE(exists("frames"));
    }

    const TemporaryFolder temporary;
};

// The seed's scene on a small picture, five frames of it.
inline std::string small_seed() {
    Scene scene = parse_scene(builtin_scenes().front().toml, "seed");
    scene.frames = 5;
    scene.size = {96, 64};
    return to_toml(scene);
}

}  // namespace ropesim
