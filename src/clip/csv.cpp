#include "clip/csv.h"

#include <array>
#include <charconv>

namespace ropesim {

std::string quoted(const std::string& field) {
    if (field.find_first_of(",\"") == std::string::npos) return field;
    std::string result = "\"";
    for (const char c : field) result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + '"';
}

void append_number(std::string& text, double number) {
    std::array<char, 32> digits;
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), number, std::chars_format::general, 17);
    text.append(digits.data(), end.ptr);
}

}  // namespace ropesim
