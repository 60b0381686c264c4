// A PNG file is refused in one line of plain text, or is a picture of its size that encodes and decodes to
// itself. Each input is tried as it is, and with its checksums mended: few changes would get past those.

#include "fuzz/target.h"
#include "image/png.h"
#include "image/png_chunks.h"

#include <zlib.h>

#include <stdexcept>
#include <vector>

using namespace ropesim;

namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes with_checksums(Bytes file) {
    std::size_t chunk = png_signature.size();
    while (file.size() >= chunk + 12) {
        const std::size_t end = chunk + 12 + number_at(file, chunk);
        if (end > file.size()) break;
        const std::size_t checked = end - chunk - 8;
        const auto checksum = static_cast<std::uint32_t>(crc32_z(0, &file[chunk + 4], checked));
        for (std::size_t i = 0; i < 4; ++i)
            file[end - 4 + i] = static_cast<std::uint8_t>(checksum >> (24 - 8 * i));
        chunk = end;
    }
    return file;
}

void try_texts(const Bytes& file) {
    try {
        decode_png_texts(file, "fuzz.png");
    } catch (const std::runtime_error& error) {
        require_plain(error.what());
    }
}

void try_picture(const Bytes& file) {
    try {
        const Image image = decode_png(file, "fuzz.png", {255, 0, 9});
        const auto pixels = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
        if (image.rgb.size() != 3 * pixels) break_off("a picture is not of its size");
        if (!(decode_png(encode_png(image, {}), "again.png") == image))
            break_off("a picture does not read back");
    } catch (const std::runtime_error& error) {
        require_plain(error.what());
    }
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    const Bytes file(bytes, bytes + size);
    for (const Bytes& each : {file, with_checksums(file)}) {
        try_texts(each);
        try_picture(each);
    }
    return 0;
}
