#include "clip/positions_file.h"

#include "clip/digest.h"

#include <cstdint>
#include <span>
#include <stdexcept>
#include <string_view>
#include <utility>

namespace ropesim {
namespace {

bool is_regular_npy(const OpenFile& file) {
    std::string begin(npy_magic.size(), '\0');
    if (file.size().value_or(0) < begin.size()) return false;
    file.read_at(0, {reinterpret_cast<std::uint8_t*>(begin.data()), begin.size()});
    return begin == npy_magic;
}

}  // namespace

PositionsFile::PositionsFile(const Scene& scene, const std::filesystem::path& path) : file_(path) {
    if (is_regular_npy(file_)) {
        Digest digest;
        npy_.emplace(
            scene, *file_.size(),
            [&](std::uint64_t offset, std::span<std::uint8_t> bytes) {
                file_.read_at(offset, bytes);
                digest.add(bytes);
            },
            path.string());
        digest_ = digest.text();
    } else {
        const std::vector<std::uint8_t> bytes = file_.read_all(largest_positions);
        const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
        digest_ = ropesim::digest(text);
        kept_ = parse_positions(scene, text, path.string());
    }
}

FrameList PositionsFile::frames() const {
    std::vector<FrameList::Range> ranges;
    if (!npy_)
        for (const auto& [frame, ropes] : kept_) ranges.push_back({frame, frame});
    else if (npy_->frames() > 0)
        ranges.push_back({0, npy_->frames() - 1});
    return FrameList(std::move(ranges));
}

void PositionsFile::check_has(const FrameList& frames) const {
    const FrameList held = this->frames();
    for (const long frame : frames)
        if (!held.contains(frame))
            throw std::runtime_error(file_.path().string() + ": holds no frame " + std::to_string(frame));
}

std::vector<Points> PositionsFile::at(long frame) const {
    if (!npy_) return kept_.at(frame);
    return npy_->at(
        frame, [this](std::uint64_t offset, std::span<std::uint8_t> bytes) { file_.read_at(offset, bytes); });
}

}  // namespace ropesim
