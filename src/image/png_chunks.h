#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace ropesim {

// The eight bytes every PNG begins with.
inline constexpr std::array<std::uint8_t, 8> png_signature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

// A piece of a PNG (Portable Network Graphics, 2nd edition, 2003, section 5): both members look into the
// bytes of the file.
struct Chunk {
    std::string_view type;  // four letters
    std::span<const std::uint8_t> data;
};

// The chunks of a whole file: the signature, IHDR first, at least one IDAT, IEND last and nothing after
// it, every checksum right. Throws std::runtime_error, "<name>: what was found, expected what", where
// something is not so.
std::vector<Chunk> png_chunks(std::span<const std::uint8_t> bytes, std::string_view name);

// What a picture's file begins with: the signature and the header, 8-bit RGB, not interlaced.
std::vector<std::uint8_t> begin_of_png(int width, int height);

// Appends a chunk: length, type, data, checksum.
void append_chunk(std::vector<std::uint8_t>& file, std::string_view type, std::span<const std::uint8_t> data);

// A chunk whose data are what is appended between the two calls; the first tells the second where it begins.
std::size_t begin_chunk(std::vector<std::uint8_t>& file, std::string_view type);
void end_chunk(std::vector<std::uint8_t>& file, std::size_t begin);

// Four bytes, most significant first, as PNG keeps its numbers.
void append_number(std::vector<std::uint8_t>& bytes, std::uint32_t number);
std::uint32_t number_at(std::span<const std::uint8_t> bytes, std::size_t offset);

}  // namespace ropesim
