#pragma once

#include "clip/frames.h"

#include <filesystem>

namespace ropesim {

// Checks, before anything is rendered, that a video can be made: its name ends in .mp4 or .gif, ffmpeg and
// ffprobe are installed, the frames leave none out. Throws std::runtime_error.
void check_video(const std::filesystem::path& video, const FrameList& frames);

// Makes a video of the frames in the folder, 30 a second, by the installed ffmpeg, and checks that it holds
// every one. Throws std::runtime_error; an older file of that name is then untouched.
void write_video(const std::filesystem::path& video, const std::filesystem::path& folder,
                 const FrameList& frames, long frames_of_clip);

}  // namespace ropesim
