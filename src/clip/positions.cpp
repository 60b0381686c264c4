#include "clip/positions.h"

#include "clip/csv.h"
#include "clip/file.h"
#include "clip/manifest.h"
#include "scene/words.h"

#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>

namespace ropesim {
namespace {

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";  // some programs begin CSV with it

constexpr std::string_view npy_magic = "\x93NUMPY\x01";  // and a zero byte: version 1.0

static_assert(std::endian::native == std::endian::little, "positions are written as little-endian doubles");

// A rope takes memory in a frame also where it has no masses there.
bool has_too_many_runs(const Positions& positions, const Scene& scene) {
    constexpr std::size_t most = std::size_t{1} << 26;
    return positions.size() * scene.ropes.size() > most;
}
constexpr const char* too_many_runs = "found too many ropes in too many frames, expected 2^26 in all at most";

// Reads fields and lines, and knows where it is.
class CsvReader {
  public:
    CsvReader(std::string_view text, std::string_view name) : rest_(text), name_(name) {
        if (rest_.starts_with(byte_order_mark)) rest_.remove_prefix(byte_order_mark.size());
    }

    bool at_end() const { return rest_.empty(); }

    [[noreturn]] void fail(const std::string& what) const {
        throw std::runtime_error(std::string(name_) + ":" + std::to_string(line_) + ": " + what);
    }

    void expect_header() {
        if (take_line() != positions_csv_header)
            fail("expected the line " + std::string(positions_csv_header));
        ++line_;
    }

    std::string take_name() {
        if (!rest_.starts_with('"')) return std::string(take_until(','));
        std::string result;
        for (rest_.remove_prefix(1); !rest_.empty(); rest_.remove_prefix(1)) {
            if (rest_.front() == '"') {
                rest_.remove_prefix(1);
                if (!rest_.starts_with('"')) {
                    take_until(',');
                    return result;
                }
            }
            result += rest_.front();
        }
        fail("a quoted name does not end");
    }

    template <class Number>
    Number take_number(char separator, const char* what) {
        const std::string_view field = separator == '\n' ? take_line() : take_until(separator);
        Number number{};
        const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), number);
        if (error != std::errc() || end != field.data() + field.size())
            fail("found '" + printable(field) + "', expected " + what);
        return number;
    }

    void next_line() { ++line_; }

  private:
    std::string_view take_until(char separator) {
        const std::size_t end = rest_.find_first_of(std::array<char, 2>{separator, '\n'}.data(), 0, 2);
        if (end == std::string_view::npos || rest_[end] != separator)
            fail("expected " + std::string(positions_csv_header));
        const std::string_view field = rest_.substr(0, end);
        rest_.remove_prefix(end + 1);
        return field;
    }

    std::string_view take_line() {
        const std::size_t end = std::min(rest_.find('\n'), rest_.size());
        std::string_view field = rest_.substr(0, end);
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
        if (field.ends_with('\r')) field.remove_suffix(1);
        return field;
    }

    std::string_view rest_;
    std::string_view name_;
    long line_ = 1;
};

std::size_t rope_index(const Scene& scene, const std::string& name, const CsvReader& reader) {
    for (std::size_t i = 0; i < scene.ropes.size(); ++i)
        if (scene.ropes[i].name == name) return i;
    reader.fail("the scene has no rope '" + printable(name) + "'");
}

// Every mass of a frame is there once: rows come in the order of nodes, so a gap shows as a wrong node.
Positions parse_csv(const Scene& scene, std::string_view text, std::string_view name) {
    CsvReader reader(text, name);
    reader.expect_header();
    Positions positions;
    std::vector<Points>* frame = nullptr;
    long frame_number = -1;
    std::size_t rope = 0;
    Eigen::Index expected_node = 0;  // 0 where a rope is complete
    for (; !reader.at_end(); reader.next_line()) {
        const long number = reader.take_number<long>(',', "a frame's number");
        const std::string rope_name = reader.take_name();
        const long node = reader.take_number<long>(',', "a node's number");
        if (expected_node == 0) {
            if (number < 0 || number >= scene.frames)
                reader.fail("frame " + std::to_string(number) + " is none of the scene's 0 to " +
                            std::to_string(scene.frames - 1));
            frame_number = number;
            rope = rope_index(scene, rope_name, reader);
            frame = &positions[number];
            if (has_too_many_runs(positions, scene)) reader.fail(too_many_runs);
            frame->resize(scene.ropes.size());
            if ((*frame)[rope].rows() > 0) reader.fail("rope '" + rope_name + "' stands twice in this frame");
            (*frame)[rope].resize(scene.ropes[rope].nodes, 2);
        }
        if (number != frame_number || rope_name != scene.ropes[rope].name || node != expected_node)
            reader.fail("expected frame " + std::to_string(frame_number) + ", rope '" +
                        scene.ropes[rope].name + "', node " + std::to_string(expected_node));
        Points& points = (*frame)[rope];
        points(node, 0) = reader.take_number<double>(',', "a number");
        points(node, 1) = reader.take_number<double>('\n', "a number");
        if (!points.row(node).isFinite().all()) reader.fail("a coordinate is not finite");
        expected_node = node + 1 == points.rows() ? 0 : node + 1;
    }
    if (expected_node != 0) reader.fail("the file ends within a rope");
    return positions;
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

Positions parse_npy(const Scene& scene, std::string_view bytes, std::string_view name) {
    Positions positions;
    for (std::size_t rope = 0; rope < scene.ropes.size(); ++rope) {
        const std::string where = std::string(name) + ": array of rope '" + scene.ropes[rope].name + "': ";
        if (bytes.size() < 10 || !bytes.starts_with(npy_magic) || bytes[7] != '\0')
            throw std::runtime_error(where + "expected one array per rope in NumPy's format 1.0");
        const std::size_t header_size =
            static_cast<unsigned char>(bytes[8]) + 256u * static_cast<unsigned char>(bytes[9]);
        const auto [frames, nodes, axes] = npy_shape(bytes.substr(10, header_size), where);
        if (nodes != scene.ropes[rope].nodes || axes != 2 || frames < 0 || frames > scene.frames)
            throw std::runtime_error(where + "found " + std::to_string(frames) + " x " +
                                     std::to_string(nodes) + " x " + std::to_string(axes) +
                                     ", expected at most " + std::to_string(scene.frames) + " x " +
                                     std::to_string(scene.ropes[rope].nodes) + " x 2");
        bytes.remove_prefix(std::min(bytes.size(), 10 + header_size));
        const std::size_t size = static_cast<std::size_t>(frames * nodes * 2) * sizeof(double);
        if (bytes.size() < size) throw std::runtime_error(where + "the file ends before its numbers do");
        using RowMajor = Eigen::Array<double, Eigen::Dynamic, 2, Eigen::RowMajor>;
        for (long frame = 0; frame < frames; ++frame) {
            RowMajor rows(nodes, 2);
            const std::size_t row_bytes = static_cast<std::size_t>(nodes * 2) * sizeof(double);
            std::memcpy(rows.data(), bytes.data() + static_cast<std::size_t>(frame) * row_bytes, row_bytes);
            if (!rows.isFinite().all())
                throw std::runtime_error(where + "a coordinate of frame " + std::to_string(frame) +
                                         " is not finite");
            positions[frame].resize(scene.ropes.size());
            if (has_too_many_runs(positions, scene)) throw std::runtime_error(where + too_many_runs);
            positions[frame][rope] = rows;
        }
        bytes.remove_prefix(size);
    }
    if (!bytes.empty())
        throw std::runtime_error(std::string(name) + ": more arrays than the scene has ropes");
    return positions;
}

}  // namespace

std::string csv_lines(const Scene& scene, long frame, const std::vector<Points>& positions) {
    std::string text;
    for (std::size_t rope = 0; rope < positions.size(); ++rope) {
        const std::string begin = std::to_string(frame) + ',' + quoted(scene.ropes[rope].name) + ',';
        for (Eigen::Index node = 0; node < positions[rope].rows(); ++node) {
            text += begin + std::to_string(node) + ',';
            append_number(text, positions[rope](node, 0));
            text += ',';
            append_number(text, positions[rope](node, 1));
            text += '\n';
        }
    }
    return text;
}

std::string to_csv(const Scene& scene, const Positions& positions) {
    std::string text = std::string(positions_csv_header) + '\n';
    for (const auto& [frame, ropes] : positions) text += csv_lines(scene, frame, ropes);
    return text;
}

Positions parse_positions(const Scene& scene, std::string_view bytes, std::string_view name) {
    return bytes.starts_with(npy_magic.substr(0, 6)) ? parse_npy(scene, bytes, name)
                                                     : parse_csv(scene, bytes, name);
}

PositionsFile read_positions(const Scene& scene, const std::filesystem::path& path) {
    const std::vector<std::uint8_t> bytes = read_file(path, largest_positions);
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return {parse_positions(scene, text, path.string()), digest(text)};
}

void check_frames(const Positions& positions, const FrameList& frames, std::string_view name) {
    for (const long frame : frames)
        if (!positions.contains(frame))
            throw std::runtime_error(std::string(name) + ": holds no frame " + std::to_string(frame));
}

}  // namespace ropesim
