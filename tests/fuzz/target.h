#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

// What each target defines: it tries the bytes, and aborts where a promise is broken. libFuzzer's name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size);

namespace ropesim {

// Says what is wrong and aborts.
[[noreturn]] void break_off(std::string_view what);

// Aborts unless a message is one line of plain text, fit for a terminal.
void require_plain(std::string_view message);

}  // namespace ropesim
