#pragma once

#include "image/image.h"
#include "image/png.h"
#include "image/row_tokens.h"
#include "image/tiles.h"

#include <map>
#include <string>
#include <vector>

namespace ropesim {

// Encodes the frames of a clip as PNG files. Gives what encode_png gives, byte for byte, whatever came
// before, but looks only at what has changed.
class FrameEncoder {
  public:
    FrameEncoder(int width, int height);

    // Outside the inked tiles the picture is of one colour; outside the changed tiles it is the one of the
    // call before. In the first call all is new. Throws as encode_png does.
    std::vector<std::uint8_t> encode(const Image& image, const Tiles& inked, const Tiles& changed,
                                     const Texts& texts);

  private:
    void append_texts(std::vector<std::uint8_t>& file, const Texts& texts);
    void append_pixels(std::vector<std::uint8_t>& file) const;

    struct KnownText {
        std::string text;
        std::vector<std::uint8_t> chunk;
    };

    std::vector<std::uint8_t> begin_;  // of every file, up to the texts
    std::map<std::string, KnownText> known_texts_;
    RowTokenizer tokenizer_;
    std::vector<Token> repeated_row_;
    TokenCounts repeated_row_counts_;
    std::vector<RowTokens> rows_;  // of each row of tiles
    bool first_ = true;
};

}  // namespace ropesim
