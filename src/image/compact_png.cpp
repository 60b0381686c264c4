#include "image/compact_png.h"

#include "image/adler32.h"
#include "image/deflate_join.h"
#include "image/png_chunks.h"
#include "image/png_texts.h"
#include "image/row_filters.h"
#include "image/zlib_stream.h"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <utility>

namespace ropesim {

namespace {

// libdeflate takes all its input at once: so many bytes of filtered rows are compressed at a time, lest a
// large picture take twice its memory.
constexpr std::size_t piece_bytes = std::size_t{3} << 20;

// Some rows, compressed; and their checksum.
struct Piece {
    std::vector<std::uint8_t> deflate_stream;
    Adler32 checksum;
};

class Compressor {
  public:
    Compressor() : compressor_(libdeflate_alloc_compressor(strongest_level), libdeflate_free_compressor) {
        if (!compressor_) throw std::bad_alloc();
    }

    std::vector<std::uint8_t> deflate_stream(std::span<const std::uint8_t> bytes) const {
        const std::size_t most = libdeflate_deflate_compress_bound(compressor_.get(), bytes.size());
        // Not a vector, whose zeros would be memory taken: most of it is never written.
        const auto stream = std::make_unique_for_overwrite<std::uint8_t[]>(most);
        const std::size_t size =
            libdeflate_deflate_compress(compressor_.get(), bytes.data(), bytes.size(), stream.get(), most);
        return {stream.get(), stream.get() + size};
    }

  private:
    static constexpr int strongest_level = 12;

    std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor*)> compressor_;
};

// The shortest of several ways to filter the rows from `begin` to `end`.
Piece compressed(const Compressor& compressor, const Image& image, int begin, int end) {
    constexpr std::array<std::optional<Filter>, 4> ways{std::nullopt, Filter::none, Filter::sub, Filter::up};
    Piece shortest;
    for (const std::optional<Filter>& way : ways) {
        const std::vector<std::uint8_t> rows = filtered_rows(image, begin, end, way);
        std::vector<std::uint8_t> stream = compressor.deflate_stream(rows);
        if (!shortest.deflate_stream.empty() && stream.size() >= shortest.deflate_stream.size()) continue;
        shortest = {std::move(stream), {}};
        shortest.checksum.add(rows);
    }
    return shortest;
}

// All rows as a zlib stream.
void append_pixels(std::vector<std::uint8_t>& file, const Image& image) {
    const Compressor compressor;
    const std::size_t row_bytes = 1 + 3 * static_cast<std::size_t>(image.width);
    const int rows_at_once = static_cast<int>(std::max<std::size_t>(piece_bytes / row_bytes, 1));
    append_zlib_header(file);
    Adler32 checksum;
    for (int begin = 0; begin < image.height; begin += rows_at_once) {
        const int end = std::min(begin + rows_at_once, image.height);
        Piece piece = compressed(compressor, image, begin, end);
        if (end < image.height) make_continued(piece.deflate_stream);
        file.insert(file.end(), piece.deflate_stream.begin(), piece.deflate_stream.end());
        checksum.add(piece.checksum);
    }
    append_checksum(file, checksum);
}

}  // namespace

std::vector<std::uint8_t> encode_compact_png(const Image& image, const Texts& texts) {
    std::vector<std::uint8_t> file = begin_of_png(image.width, image.height);
    check_texts(texts);
    for (const auto& [keyword, text] : texts) {
        const std::vector<std::uint8_t> chunk = text_chunk(keyword, text);
        file.insert(file.end(), chunk.begin(), chunk.end());
    }
    const std::size_t begin = begin_chunk(file, "IDAT");
    append_pixels(file, image);
    end_chunk(file, begin);
    append_chunk(file, "IEND", {});
    return file;
}

std::string compact_library() {
    return std::string("libdeflate ") + LIBDEFLATE_VERSION_STRING;
}

}  // namespace ropesim
