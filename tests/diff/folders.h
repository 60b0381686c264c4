#pragma once

#include "clip/temporary_folder.h"
#include "diff/compare.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace ropesim {

// Two folders, `expected` and `actual`, to put frames into.
class Folders : public testing::Test {
  protected:
    Folders();

    // Writes a frame, "frame_0007.png" for 7, to one of them or, with the same picture, to both.
    void put(const char* folder, long frame, const Image& image);
    void put_both(long frame, const Image& image);
    void put_bytes(const char* folder, const std::string& name, std::string_view bytes);

    Comparison compared(const Tolerance& tolerance = {}) const;
    std::vector<Verdict> verdicts(const Tolerance& tolerance = {}) const;

    const TemporaryFolder temporary;
};

}  // namespace ropesim
