#include "clip/npy_positions.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <utility>

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
    return shape;
}

}  // namespace

std::uint64_t NpyPositions::Array::frame_bytes() const {
    return static_cast<std::uint64_t>(nodes) * 2 * sizeof(double);
}

std::uint64_t NpyPositions::Array::frame_begin(long frame) const {
    return begin + static_cast<std::uint64_t>(frame) * frame_bytes();
}

NpyPositions::NpyPositions(const Scene& scene, std::uint64_t size, ReadAt read_at, std::string_view name)
    : read_at_(std::move(read_at)) {
    std::uint64_t begin = 0;
    for (const SceneRope& rope : scene.ropes) {
        const std::string where = std::string(name) + ": array of rope '" + rope.name + "': ";
        const auto [frames, nodes, axes] = read_shape(begin, size, where);
        if (nodes != rope.nodes || axes != 2 || frames < 0 || frames > scene.frames)
            throw std::runtime_error(where + "found " + std::to_string(frames) + " x " +
                                     std::to_string(nodes) + " x " + std::to_string(axes) +
                                     ", expected at most " + std::to_string(scene.frames) + " x " +
                                     std::to_string(rope.nodes) + " x 2");
        const Array array{frames, nodes, begin};
        begin = array.frame_begin(array.frames);
        if (begin > size) throw std::runtime_error(where + "the file ends before its numbers do");
        check_finite(array, where);
        arrays_.push_back(array);
    }
    if (begin < size) throw std::runtime_error(std::string(name) + ": more arrays than the scene has ropes");
}

std::array<long, 3> NpyPositions::read_shape(std::uint64_t& begin, std::uint64_t size,
                                             const std::string& where) const {
    const auto take_text = [&](std::size_t bytes) {
        std::string text(std::min<std::uint64_t>(bytes, size - begin), '\0');
        read_at_(begin, bytes_of(text));
        begin += text.size();
        return text;
    };
    const std::string start = take_text(start_bytes);
    if (start.size() < start_bytes || !start.starts_with(npy_magic) ||
        start.substr(npy_magic.size(), version_1_0.size()) != version_1_0)
        throw std::runtime_error(where + "expected one array per rope in NumPy's format 1.0");
    const std::size_t header_bytes =
        static_cast<unsigned char>(start[8]) + 256U * static_cast<unsigned char>(start[9]);
    return npy_shape(take_text(header_bytes), where);
}

// Many frames at a time, as reading each alone would cost more than looking at it.
void NpyPositions::check_finite(const Array& array, const std::string& where) const {
    constexpr std::uint64_t at_once = std::uint64_t{1} << 20;  // bytes
    const auto most = static_cast<long>(std::max<std::uint64_t>(at_once / array.frame_bytes(), 1));
    Eigen::ArrayXXd numbers;  // of a frame in each column
    for (long first = 0; first < array.frames; first += most) {
        numbers.resize(2 * array.nodes, std::min(most, array.frames - first));
        read_at_(array.frame_begin(first), bytes_of(numbers));
        for (long frame = 0; frame < numbers.cols(); ++frame)
            if (!numbers.col(frame).isFinite().all())
                throw std::runtime_error(where + "a coordinate of frame " + std::to_string(first + frame) +
                                         " is not finite");
    }
}

long NpyPositions::frames() const {
    long most = 0;
    for (const Array& array : arrays_) most = std::max(most, array.frames);
    return most;
}

std::vector<Points> NpyPositions::at(long frame) const {
    std::vector<Points> ropes(arrays_.size());
    Eigen::Array<double, Eigen::Dynamic, 2, Eigen::RowMajor> rows;
    for (std::size_t i = 0; i < ropes.size(); ++i) {
        if (frame >= arrays_[i].frames) continue;
        rows.resize(arrays_[i].nodes, 2);
        read_at_(arrays_[i].frame_begin(frame), bytes_of(rows));
        ropes[i] = rows;
    }
    return ropes;
}

}  // namespace ropesim
