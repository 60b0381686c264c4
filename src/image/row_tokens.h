#pragma once

#include "image/adler32.h"
#include "image/deflate.h"
#include "image/image.h"
#include "image/tiles.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ropesim {

// A deflate token in two bytes: less to keep, and an index to what is known of each. 0 to 255 are bytes as
// they are, then come repetitions of the byte before, 3 to 258 long, then those of the pixel before.
using RowToken = std::uint16_t;
inline constexpr std::size_t repetition_lengths = longest_repetition - shortest_repetition + 1;
inline constexpr std::size_t row_token_kinds = 256 + 2 * repetition_lengths;

Token token_of(RowToken token);

// Some rows of a picture as deflate tokens, each row less the row above it (the filter Up of Portable Network
// Graphics, 2nd edition, 2003, section 9). Made for frames that are one colour but for thin lines: it looks
// for runs of a byte and of a pixel and for nothing else.
struct RowTokens {
    std::vector<RowToken> tokens;
    std::vector<std::size_t> ends;  // in tokens, of each row; a row without tokens repeats the one above it
    std::uint32_t repeated_rows = 0;
    std::array<std::uint32_t, row_token_kinds> counts{};  // of tokens; without the repeated rows
    Adler32 checksum;
};

// Makes tokens of rows. Keeps a row of scratch, and nothing from one call to the next.
class RowTokenizer {
  public:
    explicit RowTokenizer(int width);

    // A row that repeats the one above it.
    std::vector<Token> repeated_row() const;

    // The rows of a row of tiles. Outside the inked tiles the picture must be of one colour. The tokens
    // depend on the picture alone.
    void tokenize(const Image& image, const Tiles& inked, int row_of_tiles, RowTokens& rows);

  private:
    // Bytes of a row of the picture.
    struct Span {
        std::size_t begin;
        std::size_t end;
    };

    void find_spans(const Tiles& inked, int first_row, int last_row);
    void add_row(const std::uint8_t* row, const std::uint8_t* above, RowTokens& rows);
    void add_filtered_row(RowTokens& rows);
    std::size_t zeros_from(std::size_t i);

    std::vector<std::uint8_t> zeros_;     // above the first row
    std::vector<std::uint8_t> filtered_;  // a row behind the byte that names its filter; zero between rows
    std::vector<RowToken> tokens_;        // of a row
    std::vector<PixelBox> boxes_;
    std::vector<Span> spans_;  // what may differ from the row above, from left to right
    std::size_t span_ = 0;     // the first that does not end before where the tokenizer is
};

}  // namespace ropesim
