#include "clip/npy_positions.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <stdexcept>

namespace ropesim {
namespace {

static_assert(std::endian::native == std::endian::little, "positions are written as little-endian doubles");

// An array begins with the magic, the version, and the size of its header in two bytes.
constexpr std::size_t start_bytes = 10;
constexpr std::string_view version_1_0("\x01\0", 2);

template <class Numbers>
std::span<std::uint8_t> bytes_of(Numbers& numbers) {
    return {reinterpret_cast<std::uint8_t*>(numbers.data()),
            static_cast<std::size_t>(numbers.size()) * sizeof(*numbers.data())};
}

// The shape in the header of one array, such as {'descr': '<f8', 'fortran_order': False, 'shape': (3, 16, 2),
// }.
std::array<long, 3> npy_shape(std::string_view header, const std::string& where) {
    std::array<long, 3> shape{};
    const std::size_t start = header.find("'shape': (");
    if (header.find("'<f8'") == std::string_view::npos ||
        header.find("'fortran_order': False") == std::string_view::npos || start == std::string_view::npos)
        throw std::runtime_error(where + "expected arrays of little-endian float64 ('<f8') in C order");
    std::string_view rest = header.substr(start + std::strlen("'shape': ("));
    for (long& extent : shape) {
        while (rest.starts_with(' ') || rest.starts_with(',')) rest.remove_prefix(1);
        const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), extent);
        if (error != std::errc()) throw std::runtime_error(where + "expected arrays of frames x nodes x 2");
        rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    }
    rest.remove_prefix(std::min(rest.find_first_not_of(" ,"), rest.size()));
    if (!rest.starts_with(')')) throw std::runtime_error(where + "expected arrays of frames x nodes x 2");
    return shape;
}

}  // namespace

std::uint64_t NpyPositions::Array::frame_bytes() const {
    return static_cast<std::uint64_t>(nodes) * 2 * sizeof(double);
}

std::uint64_t NpyPositions::Array::frame_begin(long frame) const {
    return begin + static_cast<std::uint64_t>(frame) * frame_bytes();
}

// Goes through the file from its beginning.
class NpyPositions::Reader {
  public:
    Reader(const ReadAt& read_at, std::uint64_t size) : read_at_(read_at), size_(size) {}

    bool at_end() const { return place_ == size_; }

    // The array of a rope, checked; behind it goes on. `where` begins what is thrown.
    Array take_array(const SceneRope& rope, long most_frames, const std::string& where) {
        const auto [frames, nodes, axes] = take_shape(where);
        if (nodes != rope.nodes || axes != 2 || frames < 0 || frames > most_frames)
            throw std::runtime_error(where + "found " + std::to_string(frames) + " x " +
                                     std::to_string(nodes) + " x " + std::to_string(axes) + ", expected " +
                                     std::to_string(most_frames) + " x " + std::to_string(rope.nodes) +
                                     " x 2, or fewer frames");
        const Array array{frames, nodes, place_};
        if (array.frame_begin(frames) > size_)
            throw std::runtime_error(where + "the file ends before its numbers do");
        take_numbers(array, where);
        return array;
    }

  private:
    std::string take_text(std::size_t bytes) {
        std::string text(std::min<std::uint64_t>(bytes, size_ - place_), '\0');
        read_at_(place_, bytes_of(text));
        place_ += text.size();
        return text;
    }

    std::array<long, 3> take_shape(const std::string& where) {
        const std::string start = take_text(start_bytes);
        if (start.size() < start_bytes || !start.starts_with(npy_magic) ||
            start.substr(npy_magic.size(), version_1_0.size()) != version_1_0)
            throw std::runtime_error(where + "expected one array per rope in NumPy's format 1.0");
        const std::size_t header_bytes =
            static_cast<unsigned char>(start[8]) + 256U * static_cast<unsigned char>(start[9]);
        const std::string header = take_text(header_bytes);
        if (header.size() < header_bytes) throw std::runtime_error(where + "the file ends within its header");
        return npy_shape(header, where);
    }

    // Many frames at a time, as reading each alone would cost more than looking at it.
    void take_numbers(const Array& array, const std::string& where) {
        constexpr std::uint64_t at_once = std::uint64_t{1} << 20;  // bytes
        const auto most = static_cast<long>(std::max<std::uint64_t>(at_once / array.frame_bytes(), 1));
        Eigen::ArrayXXd numbers;  // of a frame in each column
        for (long first = 0; first < array.frames; first += most) {
            numbers.resize(2 * array.nodes, std::min(most, array.frames - first));
            read_at_(array.frame_begin(first), bytes_of(numbers));
            for (long frame = 0; frame < numbers.cols(); ++frame)
                if (!numbers.col(frame).isFinite().all())
                    throw std::runtime_error(where + "a coordinate of frame " +
                                             std::to_string(first + frame) + " is not finite");
        }
        place_ = array.frame_begin(array.frames);
    }

    const ReadAt& read_at_;
    std::uint64_t size_;
    std::uint64_t place_ = 0;
};

NpyPositions::NpyPositions(const Scene& scene, std::uint64_t size, const ReadAt& read_at,
                           std::string_view name) {
    Reader reader(read_at, size);
    for (const SceneRope& rope : scene.ropes)
        arrays_.push_back(reader.take_array(rope, scene.frames,
                                            std::string(name) + ": array of rope '" + rope.name + "': "));
    if (!reader.at_end())
        throw std::runtime_error(std::string(name) + ": more arrays than the scene has ropes");
}

long NpyPositions::frames() const {
    long most = 0;
    for (const Array& array : arrays_) most = std::max(most, array.frames);
    return most;
}

std::vector<Points> NpyPositions::at(long frame, const ReadAt& read_at) const {
    std::vector<Points> ropes(arrays_.size());
    Eigen::Array<double, Eigen::Dynamic, 2, Eigen::RowMajor> rows;
    for (std::size_t i = 0; i < ropes.size(); ++i) {
        if (frame >= arrays_[i].frames) continue;
        rows.resize(arrays_[i].nodes, 2);
        read_at(arrays_[i].frame_begin(frame), bytes_of(rows));
        ropes[i] = rows;
    }
    return ropes;
}

}  // namespace ropesim
