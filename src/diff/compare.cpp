#include "diff/compare.h"

#include "clip/digest.h"
#include "clip/file.h"
#include "clip/manifest.h"
#include "clip/pace.h"
#include "image/png.h"
#include "image/png_chunks.h"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <future>
#include <set>
#include <stdexcept>

namespace ropesim {
namespace {

using Bytes = std::vector<std::uint8_t>;

bool is_digit(char c) {
    return '0' <= c && c <= '9';
}

// Takes the digits that the text begins with; gives them without leading zeros.
std::string_view take_number(std::string_view& text) {
    std::size_t end = 0;
    while (end < text.size() && is_digit(text[end])) ++end;
    std::string_view digits = text.substr(0, end);
    text.remove_prefix(end);
    while (digits.size() > 1 && digits.front() == '0') digits.remove_prefix(1);
    return digits;
}

// Names by their letters, and by the value of the numbers in them.
bool comes_before(std::string_view a, std::string_view b) {
    const std::string_view whole_a = a;
    const std::string_view whole_b = b;
    while (!a.empty() && !b.empty()) {
        if (is_digit(a.front()) && is_digit(b.front())) {
            const std::string_view number_a = take_number(a);
            const std::string_view number_b = take_number(b);
            if (number_a.size() != number_b.size()) return number_a.size() < number_b.size();
            if (number_a != number_b) return number_a < number_b;
            continue;
        }
        if (a.front() != b.front()) return a.front() < b.front();
        a.remove_prefix(1);
        b.remove_prefix(1);
    }
    if (a.empty() != b.empty()) return a.empty();
    return whole_a < whole_b;
}

struct ComesBefore {
    bool operator()(const std::string& a, const std::string& b) const { return comes_before(a, b); }
};
using Names = std::set<std::string, ComesBefore>;

long number_in(const std::string& name) {
    std::string_view stem = std::string_view(name).substr(0, name.rfind('.'));
    while (!stem.empty() && !is_digit(stem.back())) stem.remove_suffix(1);
    std::size_t begin = stem.size();
    while (begin > 0 && is_digit(stem[begin - 1])) --begin;
    long number = -1;
    const auto [end, error] = std::from_chars(stem.data() + begin, stem.data() + stem.size(), number);
    return error == std::errc() ? number : -1;
}

Names pictures_in(const std::filesystem::path& folder) {
    Names names;
    std::error_code ignored;
    for (const std::string& name : names_in(folder))
        if (std::filesystem::path(name).extension() == ".png" &&
            !std::filesystem::is_directory(folder / name, ignored))
            names.insert(name);
    return names;
}

// The bytes of a picture, of a folder or named, or what keeps them from being read, added to `problem`.
Bytes read(const std::filesystem::path& path, bool in_folder, std::string& problem) {
    try {
        return in_folder ? read_regular_file(path) : read_file(path);
    } catch (const std::runtime_error& error) {
        problem += (problem.empty() ? "" : "; ") + std::string(error.what());
        return {};
    }
}

struct Picture {
    Image over_black;
    Image over_white;  // no pixels where nothing is transparent
    Origin origin;
};

bool may_be_transparent(const Bytes& bytes, const std::string& name) {
    constexpr std::uint8_t alpha_flag = 4;  // of the colour type (PNG, 2nd edition, 2003, table 11.1)
    const std::vector<Chunk> chunks = png_chunks(bytes, name);
    return (chunks.front().data[9] & alpha_flag) != 0 ||
           std::ranges::find(chunks, "tRNS", &Chunk::type) != chunks.end();
}

std::string digest_of(const Image& image) {
    const std::string size = std::to_string(image.width) + "x";
    return size + digest({reinterpret_cast<const char*>(image.rgb.data()), image.rgb.size()});
}

Picture decode(const Bytes& bytes, const std::string& name) {
    Picture picture{decode_png(bytes, name), {}, {}};
    if (may_be_transparent(bytes, name)) picture.over_white = decode_png(bytes, name, {255, 255, 255});
    const Texts texts = decode_png_texts(bytes, name);
    picture.origin = {scene_digest_of(texts), frame_of(texts), digest_of(picture.over_black)};
    return picture;
}

Picture decode(const Bytes& bytes, const std::filesystem::path& path, std::string& problem) {
    try {
        return decode(bytes, path.string());
    } catch (const std::runtime_error& error) {
        problem += (problem.empty() ? "" : "; ") + std::string(error.what());
        return {};
    }
}

std::array<int, 2> size_of(const Picture& picture) {
    return {picture.over_black.width, picture.over_black.height};
}

// Over black, or over white where more can be seen there.
PixelDifference difference_of(const Picture& expected, const Picture& actual, int threshold) {
    const PixelDifference black = pixel_difference(expected.over_black, actual.over_black, threshold);
    const auto on_white = [](const Picture& picture) -> const Image& {
        return picture.over_white.rgb.empty() ? picture.over_black : picture.over_white;
    };
    if (expected.over_white.rgb.empty() && actual.over_white.rgb.empty()) return black;
    const PixelDifference white = pixel_difference(on_white(expected), on_white(actual), threshold);
    return std::pair(white.over, white.changed) > std::pair(black.over, black.changed) ? white : black;
}

Verdict verdict_of(const PixelDifference& difference, const Tolerance& tolerance) {
    if (difference.changed == 0) return Verdict::same_pixels;
    return difference.over <= tolerance.pixels ? Verdict::within : Verdict::different;
}

void compare_frame(const Comparison& comparison, FrameComparison& frame) {
    const std::filesystem::path expected = expected_path(comparison, frame);
    const std::filesystem::path actual = actual_path(comparison, frame);
    const Bytes expected_bytes = read(expected, comparison.folders, frame.problem);
    const Bytes actual_bytes = read(actual, comparison.folders, frame.problem);
    frame.verdict = Verdict::unreadable;
    if (!frame.problem.empty()) return;
    frame.verdict = Verdict::same_bytes;
    if (expected_bytes == actual_bytes) return;
    const Picture expected_picture = decode(expected_bytes, expected, frame.problem);
    const Picture actual_picture = decode(actual_bytes, actual, frame.problem);
    frame.expected_size = size_of(expected_picture);
    frame.actual_size = size_of(actual_picture);
    frame.expected = expected_picture.origin;
    frame.actual = actual_picture.origin;
    frame.verdict = Verdict::unreadable;
    if (!frame.problem.empty()) return;
    frame.verdict = Verdict::other_size;
    if (frame.expected_size != frame.actual_size) return;
    frame.difference = difference_of(expected_picture, actual_picture, comparison.tolerance.channel);
    frame.verdict = verdict_of(frame.difference, comparison.tolerance);
}

// Every frame that both sides have, on all processors.
void compare_frames(Comparison& comparison) {
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t i = next++; i < comparison.frames.size(); i = next++) {
            FrameComparison& frame = comparison.frames[i];
            if (frame.verdict != Verdict::missing && frame.verdict != Verdict::extra)
                compare_frame(comparison, frame);
        }
    };
    std::vector<std::future<void>> workers;
    const auto most = static_cast<std::size_t>(processors());
    for (std::size_t i = 0; i < std::min(most, comparison.frames.size()); ++i)
        workers.push_back(std::async(std::launch::async, work));
    for (std::future<void>& worker : workers) worker.get();
}

FrameComparison frame_named(const std::string& name, Verdict verdict) {
    FrameComparison frame;
    frame.name = name;
    frame.number = number_in(name);
    frame.verdict = verdict;
    return frame;
}

void list_frames(Comparison& comparison) {
    const Names expected = pictures_in(comparison.expected);
    const Names actual = pictures_in(comparison.actual);
    if (expected.empty() && actual.empty())
        throw std::runtime_error(comparison.expected.string() + " and " + comparison.actual.string() +
                                 ": neither folder holds a .png file");
    Names all = expected;
    all.insert(actual.begin(), actual.end());
    for (const std::string& name : all)
        comparison.frames.push_back(frame_named(name, !expected.contains(name) ? Verdict::extra
                                                      : !actual.contains(name) ? Verdict::missing
                                                                               : Verdict::same_bytes));
}

bool is_folder(const std::filesystem::path& path) {
    if (!std::filesystem::exists(path)) throw std::runtime_error(path.string() + ": no such file or folder");
    return std::filesystem::is_directory(path);
}

}  // namespace

std::string_view name(Verdict verdict) {
    constexpr std::array<std::string_view, 9> names{"same-bytes", "same-pixels", "within",
                                                    "chaos",      "different",   "other-size",
                                                    "missing",    "extra",       "unreadable"};
    return names[static_cast<std::size_t>(verdict)];
}

bool passes(Verdict verdict) {
    return verdict <= Verdict::chaos;
}

Comparison compare(const std::filesystem::path& expected, const std::filesystem::path& actual,
                   const Tolerance& tolerance) {
    Comparison comparison{expected, actual, is_folder(expected), tolerance, {}};
    if (comparison.folders != is_folder(actual))
        throw std::runtime_error(expected.string() + " and " + actual.string() +
                                 ": a folder and a file; expected two folders or two files");
    if (comparison.folders)
        list_frames(comparison);
    else
        comparison.frames.push_back(frame_named(expected.filename().string(), Verdict::same_bytes));
    compare_frames(comparison);
    return comparison;
}

std::filesystem::path expected_path(const Comparison& comparison, const FrameComparison& frame) {
    return comparison.folders ? comparison.expected / frame.name : comparison.expected;
}

std::filesystem::path actual_path(const Comparison& comparison, const FrameComparison& frame) {
    return comparison.folders ? comparison.actual / frame.name : comparison.actual;
}

int status(const Comparison& comparison) {
    const auto is_unreadable = [](const FrameComparison& frame) {
        return frame.verdict == Verdict::unreadable;
    };
    if (std::ranges::all_of(comparison.frames, is_unreadable)) return 1;
    return std::ranges::all_of(comparison.frames, passes, &FrameComparison::verdict) ? 0 : 3;
}

}  // namespace ropesim
