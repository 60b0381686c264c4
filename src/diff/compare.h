#pragma once

#include "diff/pixels.h"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace ropesim {

// What still passes: at most `pixels` pixels may differ by more than `channel` in a channel. Pixels are
// counted, not a share of the picture: a rope covers a hundredth of it, a link a thousandth.
struct Tolerance {
    int channel = 2;
    long pixels = 0;
};

enum class Verdict {
    same_bytes,   // the files are equal
    same_pixels,  // the files differ, their pictures do not
    within,       // the pictures differ within the tolerance
    chaos,        // they differ as the masses moved, in a frame that nobody can predict
    different,    // they differ beyond it
    other_size,
    missing,  // only in EXPECTED
    extra,    // only in ACTUAL
    unreadable,
};

// One word, such as "other-size".
std::string_view name(Verdict verdict);

bool passes(Verdict verdict);

// What a frame says of itself, where ropesim made it; else empty. Not read where the bytes are the same.
struct Origin {
    std::string scene;   // digest of the scene
    std::string frame;   // its number
    std::string pixels;  // digest of the decoded picture, whoever made it

    bool operator==(const Origin&) const = default;
};

struct FrameComparison {
    std::string name;  // of the file; of EXPECTED where two files are compared
    long number = -1;  // the last digits in it; -1 where there are none
    Verdict verdict = Verdict::same_bytes;
    PixelDifference difference;
    std::array<int, 2> expected_size{};  // width and height where it was decoded
    std::array<int, 2> actual_size{};
    Origin expected;
    Origin actual;
    std::string problem;  // why it is unreadable
};

struct Comparison {
    std::filesystem::path expected;  // as given: two files or two folders
    std::filesystem::path actual;
    bool folders = false;
    Tolerance tolerance;
    std::vector<FrameComparison> frames;  // every picture of either side, in the order of their numbers
};

// Compares two PNG files, or every file named *.png of two folders with the file of the same name; all of
// them, whatever is found. Pictures are compared as 8-bit RGB, what is transparent over black and again over
// white. Throws std::runtime_error where a path does not exist, one is a file and the other a folder, or
// neither folder holds a picture.
Comparison compare(const std::filesystem::path& expected, const std::filesystem::path& actual,
                   const Tolerance& tolerance);

// Where the frame lies, or would lie.
std::filesystem::path expected_path(const Comparison& comparison, const FrameComparison& frame);
std::filesystem::path actual_path(const Comparison& comparison, const FrameComparison& frame);

// Exit status: 0 where every frame passes, 3 where one does not, 1 where no frame could be compared.
int status(const Comparison& comparison);

}  // namespace ropesim
