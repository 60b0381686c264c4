#include "image/frame_encoder.h"

#include "image/png_chunks.h"
#include "image/png_texts.h"
#include "image/zlib_stream.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

namespace ropesim {

FrameEncoder::FrameEncoder(int width, int height)
    : begin_(begin_of_png(width, height)),
      tokenizer_(width),
      repeated_row_(tokenizer_.repeated_row()),
      rows_(static_cast<std::size_t>(Tiles(width, height).rows())) {
    assert(width > 0 && height > 0);
    for (const Token& token : repeated_row_) repeated_row_counts_.add(token, 1);
}

std::vector<std::uint8_t> FrameEncoder::encode(const Image& image, const Tiles& inked, const Tiles& changed,
                                               const Texts& texts) {
    assert(image.rgb.size() ==
           3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
    // A filtered row depends on the row above it, too.
    for (int row = 0; row < inked.rows(); ++row)
        if (first_ || changed.any_in_rows(std::max(row - 1, 0), row))
            tokenizer_.tokenize(image, inked, row, rows_[static_cast<std::size_t>(row)]);
    first_ = false;

    std::vector<std::uint8_t> file = begin_;
    append_texts(file, texts);
    const std::size_t begin = begin_chunk(file, "IDAT");
    append_pixels(file);
    end_chunk(file, begin);
    append_chunk(file, "IEND", {});
    return file;
}

void FrameEncoder::append_texts(std::vector<std::uint8_t>& file, const Texts& texts) {
    check_texts(texts);
    for (const auto& [keyword, text] : texts) {
        KnownText& known = known_texts_[keyword];
        if (known.chunk.empty() || known.text != text) known = {text, text_chunk(keyword, text)};
        file.insert(file.end(), known.chunk.begin(), known.chunk.end());
    }
}

// All rows as a zlib stream of one block.
void FrameEncoder::append_pixels(std::vector<std::uint8_t>& file) const {
    TokenCounts counts;
    std::array<std::uint32_t, row_token_kinds> row_counts{};
    Adler32 checksum;
    for (const RowTokens& rows : rows_) {
        for (std::size_t i = 0; i < row_token_kinds; ++i) row_counts[i] += rows.counts[i];
        counts.add(repeated_row_counts_, rows.repeated_rows);
        checksum.add(rows.checksum);
    }
    for (RowToken token = 0; token < row_token_kinds; ++token) counts.add(token_of(token), row_counts[token]);
    append_zlib_header(file);
    BlockWriter writer(std::move(file));
    writer.begin(counts, /*last=*/true);
    std::array<Bits, row_token_kinds> bits;
    for (RowToken token = 0; token < row_token_kinds; ++token) bits[token] = writer.bits_of(token_of(token));
    const std::vector<Bits> repeated_row = writer.bits_of(repeated_row_);
    for (const RowTokens& rows : rows_) {
        std::size_t begin = 0;
        for (const std::size_t end : rows.ends) {
            if (end == begin)
                writer.add(repeated_row);
            else
                writer.add(std::span(rows.tokens).subspan(begin, end - begin), bits);
            begin = end;
        }
    }
    writer.end();
    file = writer.finish();
    append_checksum(file, checksum);
}

}  // namespace ropesim
