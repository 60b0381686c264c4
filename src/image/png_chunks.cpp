#include "image/png_chunks.h"

#include "image/png.h"

#include <zlib.h>
#include <algorithm>
#include <array>
#include <cassert>
#include <stdexcept>
#include <string>

namespace ropesim {

namespace {

constexpr std::size_t frame_bytes = 12;  // of a chunk, around its data: length, type, checksum

std::uint32_t checksum(std::span<const std::uint8_t> bytes) {
    return static_cast<std::uint32_t>(crc32_z(0, bytes.data(), bytes.size()));
}

std::array<std::uint8_t, 4> bytes_of(std::uint32_t number) {
    std::array<std::uint8_t, 4> bytes{};
    for (std::size_t i = 0; i < 4; ++i) bytes[i] = static_cast<std::uint8_t>(number >> (24 - 8 * i));
    return bytes;
}

[[noreturn]] void fail(std::string_view name, const std::string& problem) {
    throw std::runtime_error(std::string(name) + ": " + problem);
}

std::string hexadecimal(std::uint32_t number) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text = "0x";
    for (int shift = 28; shift >= 0; shift -= 4) text += digits[(number >> shift) & 15U];
    return text;
}

// The chunk that begins at `offset`.
Chunk chunk_at(std::span<const std::uint8_t> bytes, std::size_t offset, std::string_view name) {
    const std::size_t left = bytes.size() - offset;
    if (left < frame_bytes) {
        fail(name, "the file is cut off after " + std::to_string(bytes.size()) +
                       " bytes, expected chunks up to IEND");
    }
    const std::size_t length = number_at(bytes, offset);
    if (length > left - frame_bytes) {
        fail(name, "the file is cut off after " + std::to_string(bytes.size()) +
                       " bytes, expected a chunk of " + std::to_string(length) + " bytes at byte " +
                       std::to_string(offset));
    }
    const std::uint32_t found = checksum(bytes.subspan(offset + 4, 4 + length));
    const std::uint32_t expected = number_at(bytes, offset + 8 + length);
    if (found != expected) {
        fail(name, "the chunk at byte " + std::to_string(offset) + " is damaged: its checksum is " +
                       hexadecimal(found) + ", expected " + hexadecimal(expected));
    }
    return {{reinterpret_cast<const char*>(&bytes[offset + 4]), 4}, bytes.subspan(offset + 8, length)};
}

}  // namespace

bool is_png(std::span<const std::uint8_t> bytes) {
    return bytes.size() >= png_signature.size() &&
           std::ranges::equal(bytes.first(png_signature.size()), png_signature);
}

std::vector<Chunk> png_chunks(std::span<const std::uint8_t> bytes, std::string_view name) {
    if (!is_png(bytes)) {
        fail(name, "found " + std::to_string(bytes.size()) +
                       " bytes that do not begin with the PNG signature, expected a PNG");
    }
    std::vector<Chunk> chunks;
    std::size_t offset = png_signature.size();
    while (chunks.empty() || chunks.back().type != "IEND") {
        chunks.push_back(chunk_at(bytes, offset, name));
        offset += frame_bytes + chunks.back().data.size();
    }
    if (offset != bytes.size()) {
        fail(name, "found " + std::to_string(bytes.size() - offset) + " bytes after IEND, expected none");
    }
    if (chunks.front().type != "IHDR" || chunks.front().data.size() != 13) {
        fail(name, "the first chunk is no IHDR of 13 bytes, expected one");
    }
    if (std::ranges::find(chunks, "IDAT", &Chunk::type) == chunks.end()) {
        fail(name, "found no IDAT chunk, expected at least one");
    }
    return chunks;
}

std::vector<std::uint8_t> begin_of_png(int width, int height) {
    constexpr std::uint8_t rgb = 2;  // the colour type
    std::vector<std::uint8_t> header;
    append_number(header, static_cast<std::uint32_t>(width));
    append_number(header, static_cast<std::uint32_t>(height));
    header.insert(header.end(), {8, rgb, 0, 0, 0});
    std::vector<std::uint8_t> file(png_signature.begin(), png_signature.end());
    append_chunk(file, "IHDR", header);
    return file;
}

void append_chunk(std::vector<std::uint8_t>& file, std::string_view type,
                  std::span<const std::uint8_t> data) {
    const std::size_t begin = begin_chunk(file, type);
    file.insert(file.end(), data.begin(), data.end());
    end_chunk(file, begin);
}

std::size_t begin_chunk(std::vector<std::uint8_t>& file, std::string_view type) {
    assert(type.size() == 4);
    const std::size_t begin = file.size();
    append_number(file, 0);  // the length, once it is known
    file.insert(file.end(), type.begin(), type.end());
    return begin;
}

void end_chunk(std::vector<std::uint8_t>& file, std::size_t begin) {
    const auto typed = std::span(file).subspan(begin + 4);
    const std::size_t length = typed.size() - 4;
    assert(length < 0x80000000U);
    std::ranges::copy(bytes_of(static_cast<std::uint32_t>(length)),
                      file.begin() + static_cast<std::ptrdiff_t>(begin));
    append_number(file, checksum(typed));
}

void append_number(std::vector<std::uint8_t>& bytes, std::uint32_t number) {
    const std::array<std::uint8_t, 4> its_bytes = bytes_of(number);
    bytes.insert(bytes.end(), its_bytes.begin(), its_bytes.end());
}

std::uint32_t number_at(std::span<const std::uint8_t> bytes, std::size_t offset) {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < 4; ++i) number = number << 8 | bytes[offset + i];
    return number;
}

}  // namespace ropesim
