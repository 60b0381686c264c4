#include "clip/video.h"

#include "clip/file.h"
#include "clip/interrupt.h"
#include "clip/process.h"

#include <stdexcept>
#include <string>

namespace ropesim {
namespace {

constexpr const char* frames_per_second = "30";

// H.264 as every player takes it: even sides, 4:2:0. A GIF gets a palette of its own.
std::vector<std::string> encoding(const std::filesystem::path& video) {
    if (video.extension() == ".gif")
        return {"-filter_complex", "split[a][b];[a]palettegen[p];[b][p]paletteuse", "-f", "gif"};
    return {"-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-c:v", "libx264", "-pix_fmt", "yuv420p", "-f", "mp4"};
}

std::size_t counted_frames(const std::string& file) {
    const std::string text =
        run_program({"ffprobe", "-v", "error", "-select_streams", "v:0", "-count_packets", "-show_entries",
                     "stream=nb_read_packets", "-of", "csv=p=0", file},
                    ".");
    return text.empty() ? 0 : std::stoul(text);
}

}  // namespace

void check_video(const std::filesystem::path& video, const FrameList& frames) {
    if (video.extension() != ".mp4" && video.extension() != ".gif")
        throw std::runtime_error("video '" + video.string() + "': expected a name that ends in .mp4 or .gif");
    for (const char* program : {"ffmpeg", "ffprobe"})
        if (!is_installed(program))
            throw std::runtime_error(std::string("video needs ") + program +
                                     ", which is not installed; try: apt-get install ffmpeg");
    if (frames.ranges().size() > 1)
        throw std::runtime_error("video needs frames without a gap; " + to_string(frames) +
                                 " leaves out frame " + std::to_string(frames.ranges()[0].last + 1));
}

void write_video(const std::filesystem::path& video, const std::filesystem::path& folder,
                 const FrameList& frames, long frames_of_clip) {
    for (const long frame : frames)
        if (!std::filesystem::exists(folder / frame_name(frame, frames_of_clip)))
            throw std::runtime_error("video: " + (folder / frame_name(frame, frames_of_clip)).string() +
                                     " is missing");
    std::filesystem::path made = video;
    made.replace_filename(".ropesim-" + video.filename().string());
    const std::string file =
        "file:" + made.string();  // a name that begins with - is no option, with a: no protocol
    std::vector<std::string> command{"ffmpeg",     "-v",    "error", "-y",         "-f",
                                     "image2pipe", "-c:v",  "png",   "-framerate", frames_per_second,
                                     "-i",         "pipe:0"};
    for (const std::string& argument : encoding(video)) command.push_back(argument);
    command.push_back(file);
    const Interrupts interrupts;
    try {
        run_program(command, ".", [&](const auto& write) {
            for (const long frame : frames) {
                Interrupts::check();
                const auto bytes = read_regular_file(folder / frame_name(frame, frames_of_clip));
                write(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
            }
        });
        const std::size_t counted = counted_frames(file);
        if (counted != frames.size())
            throw std::runtime_error("video: ffmpeg wrote " + std::to_string(counted) + " of " +
                                     std::to_string(frames.size()) + " frames");
        Interrupts::check();
        std::filesystem::rename(made, video);
    } catch (...) {
        std::error_code ignored;
        std::filesystem::remove(made, ignored);
        throw;
    }
}

}  // namespace ropesim
