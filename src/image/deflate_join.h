#pragma once

#include <cstdint>
#include <vector>

namespace ropesim {

// Makes a deflate stream one that another can follow byte by byte: its last block no longer says that it is
// the last, and an empty stored block (RFC 1951, section 3.2.4) ends it with a whole byte. Throws
// std::bad_alloc, or std::invalid_argument where it is no deflate stream from the first byte to the last.
void make_continued(std::vector<std::uint8_t>& deflate_stream);

}  // namespace ropesim
