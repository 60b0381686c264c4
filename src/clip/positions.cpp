#include "clip/positions.h"

#include "clip/csv.h"
#include "clip/npy_positions.h"
#include "scene/words.h"

#include <array>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <span>
#include <stdexcept>

namespace ropesim {
namespace {

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";  // some programs begin CSV with it

// A rope takes memory in a frame also where it has no masses there.
bool too_many(std::size_t frames, const Scene& scene) {
    constexpr std::size_t most = std::size_t{1} << 26;
    return frames * scene.ropes.size() > most;
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
            fail("expected the line " + std::string(positions_csv_header) + ", or NumPy's format");
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
            if (too_many(positions.size(), scene)) reader.fail(too_many_runs);
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

Positions parse_npy(const Scene& scene, std::string_view bytes, std::string_view name) {
    const auto copy = [bytes](std::uint64_t offset, std::span<std::uint8_t> part) {
        std::memcpy(part.data(), bytes.data() + offset, part.size());
    };
    const NpyPositions npy(scene, bytes.size(), copy, name);
    if (too_many(static_cast<std::size_t>(npy.frames()), scene))
        throw std::runtime_error(std::string(name) + ": " + too_many_runs);
    Positions positions;
    for (long frame = 0; frame < npy.frames(); ++frame) positions[frame] = npy.at(frame, copy);
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
    return bytes.starts_with(npy_magic) ? parse_npy(scene, bytes, name) : parse_csv(scene, bytes, name);
}

}  // namespace ropesim
