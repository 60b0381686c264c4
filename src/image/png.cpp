#include "image/png.h"

#include "image/frame_encoder.h"
#include "image/png_chunks.h"

#include <png.h>
#include <algorithm>
#include <csetjmp>
#include <cstdlib>
#include <cstring>
#include <new>
#include <stdexcept>

namespace ropesim {

namespace {

constexpr std::uint32_t widest = 65535;                    // pixels a side of a picture that is read
constexpr std::uint64_t largest = std::uint64_t{1} << 28;  // pixels in all

[[noreturn]] void fail(std::string_view name, const std::string& problem) {
    throw std::runtime_error(std::string(name) + ": " + problem);
}

// Refuses pictures beyond the limits, and those of which the compressed pixels cannot hold what the header
// promises (deflate gives at most 258 bytes for 2 bits), before memory is taken for them.
void check_size(std::span<const Chunk> chunks, std::string_view name) {
    const std::span<const std::uint8_t> ihdr = chunks.front().data;
    const std::uint32_t width = number_at(ihdr, 0);
    const std::uint32_t height = number_at(ihdr, 4);
    const std::string size = std::to_string(width) + "x" + std::to_string(height) + " pixels";
    if (width == 0 || height == 0 || width > widest || height > widest ||
        std::uint64_t{width} * height > largest) {
        fail(name, "found " + size + ", expected 1 to 65535 a side and at most 2^28 in all");
    }
    std::uint64_t compressed = 0;
    for (const Chunk& chunk : chunks) compressed += chunk.type == "IDAT" ? chunk.data.size() : 0;
    const std::uint64_t least_bits_per_pixel = ihdr[8];
    if (std::uint64_t{width} * height * least_bits_per_pixel / 8 > compressed * 1032) {
        fail(name, "found " + std::to_string(compressed) + " bytes of pixels, expected enough for " + size);
    }
}

// A PNG in memory being read by libpng.
//
// libpng leaves by longjmp where the bytes are bad. Each function that it may leave sets its own jump,
// returns false when jumped to, and has no object with a destructor; nor have the callbacks.
class PngReader {
  public:
    PngReader(std::span<const std::uint8_t> bytes, std::string_view name) : bytes_(bytes), name_(name) {
        png_ = png_create_read_struct_2(PNG_LIBPNG_VER_STRING, this, keep_error, ignore_warning, this,
                                        take_memory, give_back);
        info_ = png_ == nullptr ? nullptr : png_create_info_struct(png_);
        if (info_ == nullptr) {
            png_destroy_read_struct(&png_, nullptr, nullptr);
            throw std::bad_alloc();
        }
    }
    PngReader(const PngReader&) = delete;
    PngReader& operator=(const PngReader&) = delete;
    ~PngReader() { png_destroy_read_struct(&png_, &info_, nullptr); }

    Image read(Color background) {
        if (!begin()) refuse();
        Image image{static_cast<int>(png_get_image_width(png_, info_)),
                    static_cast<int>(png_get_image_height(png_, info_)),
                    {}};
        const std::size_t stride = png_get_rowbytes(png_, info_);
        std::vector<std::uint8_t> pixels(stride * static_cast<std::size_t>(image.height));
        std::vector<png_bytep> rows;
        for (std::size_t i = 0; i < pixels.size(); i += stride) rows.push_back(&pixels[i]);
        if (!finish(rows.data())) refuse();
        image.rgb = png_get_channels(png_, info_) == 4 ? over(pixels, background) : std::move(pixels);
        return image;
    }

  private:
    // Up to the pixels, which are asked for as 8-bit RGB or RGBA.
    bool begin() {
        if (setjmp(png_jmpbuf(png_)) != 0) return false;
        png_set_read_fn(png_, this, take_bytes);
        png_set_user_limits(png_, widest, widest);
        png_set_benign_errors(png_, 0);
        png_set_keep_unknown_chunks(png_, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
        png_read_info(png_, info_);
        png_set_expand(png_);
        png_set_scale_16(png_);
        png_set_gray_to_rgb(png_);
        png_set_interlace_handling(png_);
        png_read_update_info(png_, info_);
        return true;
    }

    bool finish(png_bytepp rows) {
        if (setjmp(png_jmpbuf(png_)) != 0) return false;
        png_read_image(png_, rows);
        png_read_end(png_, nullptr);
        return true;
    }

    static std::vector<std::uint8_t> over(std::span<const std::uint8_t> rgba, Color background) {
        std::vector<std::uint8_t> rgb;
        rgb.reserve(rgba.size() / 4 * 3);
        for (std::size_t i = 0; i < rgba.size(); i += 4) {
            const int alpha = rgba[i + 3];
            for (std::size_t channel = 0; channel < 3; ++channel) {
                const int mixed = rgba[i + channel] * alpha + background[channel] * (255 - alpha);
                rgb.push_back(static_cast<std::uint8_t>((mixed + 127) / 255));
            }
        }
        return rgb;
    }

    [[noreturn]] void refuse() const {
        if (out_of_memory_) throw std::bad_alloc();  // which says nothing of the file
        fail(name_, std::string("libpng: ") + error_.data() + ", expected a whole PNG");
    }

    static png_voidp take_memory(png_structp png, png_alloc_size_t size) {
        void* const memory = std::malloc(size);
        if (!memory) static_cast<PngReader*>(png_get_mem_ptr(png))->out_of_memory_ = true;
        return memory;
    }

    static void give_back(png_structp, png_voidp memory) { std::free(memory); }

    static void keep_error(png_structp png, png_const_charp message) {
        auto* reader = static_cast<PngReader*>(png_get_error_ptr(png));
        std::strncpy(reader->error_.data(), message, reader->error_.size() - 1);
        png_longjmp(png, 1);
    }

    static void ignore_warning(png_structp, png_const_charp) {}

    static void take_bytes(png_structp png, png_bytep to, std::size_t size) {
        auto* reader = static_cast<PngReader*>(png_get_io_ptr(png));
        if (size > reader->bytes_.size()) png_error(png, "the file is cut off");
        std::memcpy(to, reader->bytes_.data(), size);
        reader->bytes_ = reader->bytes_.subspan(size);
    }

    std::span<const std::uint8_t> bytes_;  // not read yet
    std::string_view name_;
    std::array<char, 160> error_{};
    bool out_of_memory_ = false;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
};

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image, const Texts& texts) {
    Tiles all(image.width, image.height);
    all.add({0, 0, image.width, image.height});
    return FrameEncoder(image.width, image.height).encode(image, all, all, texts);
}

Image decode_png(std::span<const std::uint8_t> bytes, std::string_view name) {
    return decode_png(bytes, name, {0, 0, 0});
}

Image decode_png(std::span<const std::uint8_t> bytes, std::string_view name, Color background) {
    check_size(png_chunks(bytes, name), name);
    return PngReader(bytes, name).read(background);
}

std::string png_library() {
    return std::string("libpng ") + png_get_libpng_ver(nullptr);
}

}  // namespace ropesim
