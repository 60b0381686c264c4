#include "image/frame_encoder.h"

#include "image/png_chunks.h"
#include "image/png_texts.h"
#include "image/zlib_stream.h"

#include <algorithm>
#include <cassert>

namespace ropesim {

FrameEncoder::FrameEncoder(int width, int height)
    : begin_(begin_of_png(width, height)),
      tokenizer_(width),
      repeated_row_(tokenizer_.repeated_row()),
      rows_(static_cast<std::size_t>(Tiles(width, height).rows())) {
    assert(width > 0 && height > 0);
    repeated_row_counts_.add(repeated_row_);
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
    append_chunk(file, "IDAT", pixels());
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
std::vector<std::uint8_t> FrameEncoder::pixels() const {
    TokenCounts counts;
    Adler32 checksum;
    for (const RowTokens& rows : rows_) {
        counts.add(rows.counts, 1);
        counts.add(repeated_row_counts_, rows.repeated_rows);
        checksum.add(rows.checksum);
    }
    BlockWriter writer(zlib_header());
    writer.begin(counts, /*last=*/true);
    const std::vector<Bits> repeated_row = writer.bits_of(repeated_row_);
    for (const RowTokens& rows : rows_) {
        std::size_t begin = 0;
        for (const std::size_t end : rows.ends) {
            if (end == begin)
                writer.add(repeated_row);
            else
                writer.add(std::span(rows.tokens).subspan(begin, end - begin));
            begin = end;
        }
    }
    writer.end();
    std::vector<std::uint8_t> stream = writer.finish();
    append_checksum(stream, checksum);
    return stream;
}

}  // namespace ropesim
