#include "clip/positions_writer.h"

#include "clip/file.h"
#include "clip/positions.h"

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <stdexcept>

namespace ropesim {
namespace {

class CsvWriter : public PositionsWriter {
  public:
    CsvWriter(const std::string& file, const Scene& scene) : scene_(scene), file_(file, Place::named) {
        file_.append(std::string(positions_csv_header) + '\n');
    }

    void add(long frame, const std::vector<Points>& positions) override {
        file_.append(csv_lines(scene_, frame, positions));
    }

    void finish() override { file_.finish(); }

  private:
    const Scene& scene_;
    NewFile file_;
};

// The arrays stand one after the other, each with room for all frames. Where a rope diverges, those behind it
// move up in the end.
class NpyWriter : public PositionsWriter {
  public:
    NpyWriter(const std::string& file, const Scene& scene, long frames) : file_(file, Place::named) {
        std::uint64_t begin = 0;
        for (const SceneRope& rope : scene.ropes) {
            arrays_.push_back({rope.nodes, begin, 0});
            begin += npy_header_size + static_cast<std::uint64_t>(frames) * arrays_.back().row_bytes();
        }
    }

    void add(long, const std::vector<Points>& positions) override {
        for (std::size_t i = 0; i < arrays_.size(); ++i) {
            if (positions[i].rows() == 0) continue;
            row_ = positions[i];
            file_.write_at(arrays_[i].end(), {reinterpret_cast<const std::uint8_t*>(row_.data()),
                                              static_cast<std::size_t>(arrays_[i].row_bytes())});
            ++arrays_[i].frames;
        }
    }

    void finish() override {
        std::uint64_t begin = 0;
        for (Array& array : arrays_) {
            move_numbers(array, begin);
            const std::string header = npy_header(array.frames, array.nodes);
            file_.write_at(begin, {reinterpret_cast<const std::uint8_t*>(header.data()), header.size()});
            begin = array.end();
        }
        file_.set_size(begin);
        file_.finish();
    }

  private:
    struct Array {
        long nodes;
        std::uint64_t begin;  // of its header, bytes
        long frames;          // that it holds

        std::uint64_t row_bytes() const { return static_cast<std::uint64_t>(nodes) * 2 * sizeof(double); }
        std::uint64_t size() const { return static_cast<std::uint64_t>(frames) * row_bytes(); }
        std::uint64_t end() const { return begin + npy_header_size + size(); }
    };

    void move_numbers(Array& array, std::uint64_t begin) {
        std::vector<std::uint8_t> bytes;
        for (std::uint64_t done = 0; array.begin != begin && done < array.size(); done += bytes.size()) {
            bytes.resize(std::min<std::uint64_t>(array.size() - done, std::uint64_t{1} << 20));
            file_.read_at(array.begin + npy_header_size + done, bytes);
            file_.write_at(begin + npy_header_size + done, bytes);
        }
        array.begin = begin;
    }

    NewFile file_;
    std::vector<Array> arrays_;
    Eigen::Array<double, Eigen::Dynamic, 2, Eigen::RowMajor> row_;  // of an array: one frame
};

}  // namespace

std::unique_ptr<PositionsWriter> make_positions_writer(const std::string& file, const Scene& scene,
                                                       const FrameList& frames) {
    if (!file.ends_with(".npy")) return std::make_unique<CsvWriter>(file, scene);
    if (frames.back() + 1 != static_cast<long>(frames.size()))
        throw std::runtime_error(file + ": a .npy file holds every frame from 0 on; write .csv for some");
    return std::make_unique<NpyWriter>(file, scene, frames.back() + 1);
}

std::string npy_header(long frames, long nodes) {
    std::string text = "{'descr': '<f8', 'fortran_order': False, 'shape': (" + std::to_string(frames) + ", " +
                       std::to_string(nodes) + ", 2), }";
    const std::string begin = "\x93NUMPY\x01" + std::string(1, '\0');  // version 1.0
    const std::size_t size = npy_header_size - begin.size() - 2;       // which stands in two bytes
    assert(text.size() < size);
    text.resize(size - 1, ' ');
    return begin + static_cast<char>(size) + '\0' + text + '\n';
}

}  // namespace ropesim
