#include "clip/verify_clip.h"

#include "clip/file.h"
#include "clip/progress.h"
#include "image/png.h"
#include "scene/words.h"

#include <algorithm>
#include <atomic>
#include <future>
#include <stdexcept>

namespace ropesim {
namespace {

Manifest manifest_of(const std::filesystem::path& folder) {
    const std::filesystem::path path = manifest_path(folder);
    if (!std::filesystem::is_directory(folder))
        throw std::runtime_error(folder.string() + ": no such folder");
    if (!std::filesystem::exists(path))
        throw std::runtime_error(path.string() +
                                 ": missing, no render has finished here; the render's own command with "
                                 "--resume finishes it");
    const std::vector<std::uint8_t> bytes = read_regular_file(path);
    return parse_manifest({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, path.string());
}

std::string size_text(int width, int height) {
    return std::to_string(width) + "x" + std::to_string(height);
}

// What the texts of a whole frame say against it; "" where they are right.
std::string fault_of_texts(const Texts& texts, long frame, const Manifest& manifest) {
    if (scene_digest_of(texts).empty()) return "not made by ropesim";
    if (scene_digest_of(texts) != manifest.digest) return "of another scene";
    if (version_of(texts) != manifest.version)
        return "of another version, '" + printable(version_of(texts)) + "'";
    if (positions_digest_of(texts) != manifest.positions_digest) return "drawn from other positions";
    if (frame_of(texts) != std::to_string(frame))
        return "wrong number, it is frame '" + printable(frame_of(texts)) + "'";
    return "";
}

std::string fault_of(const std::filesystem::path& path, long frame, const Manifest& manifest) {
    if (std::filesystem::symlink_status(path).type() == std::filesystem::file_type::not_found)
        return "missing";
    try {
        const std::vector<std::uint8_t> bytes = read_regular_file(path);
        const Image image = decode_png(bytes, path.string());
        std::string fault = fault_of_texts(decode_png_texts(bytes, path.string()), frame, manifest);
        const auto [width, height] = manifest.scene.size;
        if (!fault.empty() || (image.width == width && image.height == height)) return fault;
        return "broken: " + size_text(image.width, image.height) + " pixels, expected " +
               size_text(width, height);
    } catch (const std::runtime_error& error) {
        return "broken: " + std::string(error.what()).substr(path.string().size() + 2);  // behind its name
    }
}

// The faults of as many frames; "" where there is none.
std::vector<std::string> faults_of(const std::filesystem::path& folder, const std::vector<long>& frames,
                                   const Manifest& manifest, int threads) {
    std::vector<std::string> faults(frames.size());
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t i = next++; i < frames.size(); i = next++)
            faults[i] = fault_of(folder / frame_name(frames[i], manifest.scene.frames), frames[i], manifest);
    };
    std::vector<std::future<void>> workers;
    for (int i = 1; i < threads; ++i) workers.push_back(std::async(std::launch::async, work));
    work();
    for (std::future<void>& worker : workers) worker.get();
    return faults;
}

void add_faults(const std::vector<long>& frames, const std::vector<std::string>& faults,
                std::vector<FrameFault>& all) {
    for (std::size_t i = 0; i < frames.size(); ++i) {
        if (faults[i].empty()) continue;
        if (!all.empty() && all.back().what == faults[i] && all.back().frames.last == frames[i] - 1)
            all.back().frames.last = frames[i];
        else
            all.push_back({{frames[i], frames[i]}, faults[i]});
    }
}

long frames_with_faults(std::vector<FrameFault>::const_iterator begin,
                        std::vector<FrameFault>::const_iterator end) {
    long count = 0;
    for (; begin != end; ++begin) count += begin->frames.last - begin->frames.first + 1;
    return count;
}

}  // namespace

std::vector<FrameFault> find_faults(const std::filesystem::path& folder, const Manifest& manifest,
                                    const FrameList& frames, int threads, bool show_progress) {
    constexpr std::size_t at_once = 1024;  // frames whose faults are kept apart
    std::vector<FrameFault> faults;
    Progress progress(static_cast<long>(frames.size()), "frames", show_progress);
    std::vector<long> next;
    for (auto frame = frames.begin(); frame != frames.end();) {
        next.clear();
        for (; frame != frames.end() && next.size() < at_once; ++frame) next.push_back(*frame);
        add_faults(next, faults_of(folder, next, manifest, threads), faults);
        progress.done(static_cast<long>(next.size()));
    }
    return faults;
}

Verification verify_clip(const std::filesystem::path& folder, int threads, bool show_progress) {
    Verification verification{manifest_of(folder), {}, {}, stray_temporaries(folder)};
    const FrameList& named = verification.manifest.frames;
    verification.faults = find_faults(folder, verification.manifest, named, threads, show_progress);
    std::vector<long> unnamed;
    for (const long frame : frames_in(folder))
        if (!named.contains(frame)) unnamed.push_back(frame);
    verification.unnamed = unnamed;
    return verification;
}

FrameList faulty_frames(const Verification& verification) {
    std::vector<FrameList::Range> ranges;
    for (const FrameFault& fault : verification.faults) ranges.push_back(fault.frames);
    return FrameList(std::move(ranges));
}

std::string fault_lines(const std::filesystem::path& folder, const Verification& verification,
                        std::size_t most) {
    const auto name = [&](long frame) { return frame_name(frame, verification.manifest.scene.frames); };
    const std::vector<FrameFault>& faults = verification.faults;
    const auto end = faults.begin() + static_cast<std::ptrdiff_t>(std::min(most, faults.size()));
    std::string text;
    for (auto fault = faults.begin(); fault != end; ++fault) {
        text += one_line((folder / name(fault->frames.first)).string());
        if (fault->frames.last > fault->frames.first) text += " to " + name(fault->frames.last);
        text += ": " + one_line(fault->what) + "\n";
    }
    if (end != faults.end())
        text += "and " + std::to_string(frames_with_faults(end, faults.end())) + " more frames\n";
    for (const std::filesystem::path& stray : verification.strays)
        text += one_line(stray.string()) + ": a temporary file that no process of this machine is writing\n";
    return text;
}

}  // namespace ropesim
