#include "image/png_texts.h"

#include "image/png_chunks.h"
#include "image/zlib_stream.h"

#include <zlib.h>
#include <algorithm>
#include <new>
#include <stdexcept>

// The layout of the text chunks: Portable Network Graphics, 2nd edition, 2003, section 11.3.4.

namespace ropesim {

namespace {

using Bytes = std::span<const std::uint8_t>;

constexpr std::size_t longest_keyword = 79;
constexpr std::size_t most_text = std::size_t{64} << 20;  // bytes of text in one file, unpacked

Bytes bytes_of(std::string_view text) {
    return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

std::string text_of(Bytes bytes) {
    return std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

// The data of an iTXt chunk without language or translated keyword.
std::vector<std::uint8_t> international_text(const std::string& keyword, const std::string& text) {
    const Bytes plain = bytes_of(text);
    const std::vector<std::uint8_t> stream = zlib_stream_of_text(plain);
    const bool shorter = stream.size() < plain.size();
    const Bytes body = shorter ? Bytes(stream) : plain;
    std::vector<std::uint8_t> data(keyword.begin(), keyword.end());
    // The keyword's end, whether compressed, by which method, the ends of language and translated keyword.
    data.insert(data.end(), {0, static_cast<std::uint8_t>(shorter ? 1 : 0), 0, 0, 0});
    data.insert(data.end(), body.begin(), body.end());
    return data;
}

// One zlib stream being unpacked.
class Unpacker {
  public:
    explicit Unpacker(Bytes stream) {
        if (inflateInit(&state_) != Z_OK) throw std::bad_alloc();
        state_.next_in = const_cast<Bytef*>(stream.data());
        state_.avail_in = static_cast<uInt>(stream.size());
    }
    Unpacker(const Unpacker&) = delete;
    Unpacker& operator=(const Unpacker&) = delete;
    ~Unpacker() { inflateEnd(&state_); }

    // Appends what comes next, at most as many bytes as `text` has already (or 4096); zlib's status.
    int append_some(std::string& text) {
        const std::size_t before = text.size();
        text.resize(before + std::max<std::size_t>(4096, before));
        state_.next_out = reinterpret_cast<Bytef*>(text.data() + before);
        state_.avail_out = static_cast<uInt>(text.size() - before);
        const int status = inflate(&state_, Z_NO_FLUSH);
        text.resize(text.size() - state_.avail_out);
        if (status == Z_MEM_ERROR) throw std::bad_alloc();
        return status;
    }

  private:
    z_stream state_{};
};

// Latin-1, whose characters are Unicode's first 256, as UTF-8.
std::string utf8(Bytes latin1) {
    std::string text;
    for (const std::uint8_t character : latin1) {
        if (character < 0x80) {
            text += static_cast<char>(character);
        } else {
            text += static_cast<char>(0xc0 | character >> 6);
            text += static_cast<char>(0x80 | (character & 0x3f));
        }
    }
    return text;
}

// Reads the text chunks of one file.
class TextReader {
  public:
    explicit TextReader(std::string_view file) : file_(file) {}

    void read(const Chunk& chunk, Texts& texts) {
        if (chunk.type != "tEXt" && chunk.type != "zTXt" && chunk.type != "iTXt") return;
        Bytes rest = chunk.data;
        const std::string keyword = text_of(take_field(rest, "keyword"));
        if (keyword.empty() || keyword.size() > longest_keyword) {
            fail("the keyword of a text has " + std::to_string(keyword.size()) +
                 " characters, expected 1 to 79");
        }
        if (chunk.type == "tEXt") texts.emplace(keyword, utf8(counted(rest)));
        if (chunk.type == "zTXt") texts.emplace(keyword, compressed_latin1(rest));
        if (chunk.type == "iTXt") texts.emplace(keyword, international(rest));
    }

  private:
    std::string compressed_latin1(Bytes rest) {
        take_method(rest);
        return utf8(bytes_of(unpacked(rest)));
    }

    std::string international(Bytes rest) {
        const bool is_compressed = take_byte(rest) != 0;
        take_method(rest);
        take_field(rest, "language");
        take_field(rest, "translated keyword");
        return is_compressed ? unpacked(rest) : text_of(counted(rest));
    }

    std::string unpacked(Bytes stream) {
        Unpacker unpacker(stream);
        std::string text;
        int status = Z_OK;
        while (status == Z_OK && text.size() <= left_) status = unpacker.append_some(text);
        counted(bytes_of(text));
        if (status != Z_STREAM_END) fail("a compressed text is damaged, expected a whole zlib stream");
        return text;
    }

    Bytes counted(Bytes text) {
        if (text.size() > left_) fail("found more than 64 MB of text, expected less");
        left_ -= text.size();
        return text;
    }

    // The bytes up to the next zero, which is taken away too.
    Bytes take_field(Bytes& rest, const std::string& what) {
        const auto zero = std::ranges::find(rest, 0);
        if (zero == rest.end()) fail("the " + what + " of a text has no end, expected a zero byte");
        const auto size = static_cast<std::size_t>(zero - rest.begin());
        const Bytes field = rest.first(size);
        rest = rest.subspan(size + 1);
        return field;
    }

    std::uint8_t take_byte(Bytes& rest) {
        if (rest.empty()) fail("a text chunk ends after its keyword, expected its compression");
        const std::uint8_t byte = rest.front();
        rest = rest.subspan(1);
        return byte;
    }

    void take_method(Bytes& rest) {
        const int method = take_byte(rest);
        if (method != 0) fail("a text is compressed by method " + std::to_string(method) + ", expected 0");
    }

    [[noreturn]] void fail(const std::string& problem) const {
        throw std::runtime_error(file_ + ": " + problem);
    }

    std::string file_;
    std::size_t left_ = most_text;
};

}  // namespace

void check_texts(const Texts& texts) {
    std::size_t size = 0;
    for (const auto& [keyword, text] : texts) {
        if (keyword.empty() || keyword.size() > longest_keyword || keyword.find('\0') != keyword.npos) {
            throw std::runtime_error("PNG text '" + keyword + "': its keyword has " +
                                     std::to_string(keyword.size()) +
                                     " characters, expected 1 to 79, none zero");
        }
        if (text.find('\0') != text.npos) {
            throw std::runtime_error("PNG text '" + keyword + "': found a zero character, expected none");
        }
        size += text.size();
    }
    if (size > most_text) {
        throw std::runtime_error("PNG texts: found " + std::to_string(size) + " bytes, expected at most " +
                                 std::to_string(most_text));
    }
}

std::vector<std::uint8_t> text_chunk(const std::string& keyword, const std::string& text) {
    std::vector<std::uint8_t> chunk;
    append_chunk(chunk, "iTXt", international_text(keyword, text));
    return chunk;
}

Texts decode_png_texts(std::span<const std::uint8_t> bytes, std::string_view name) {
    Texts texts;
    TextReader reader{std::string(name)};
    for (const Chunk& chunk : png_chunks(bytes, name)) reader.read(chunk, texts);
    return texts;
}

}  // namespace ropesim
