#include "scene/words.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

namespace ropesim {
namespace {

constexpr std::size_t longest_shown = 60;
constexpr std::size_t longest_compared = 64;

// Optimal string alignment distance, row by row.
std::size_t distance(std::string_view a, std::string_view b) {
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i)
        for (std::size_t j = 0; j <= b.size(); ++j) {
            if (i == 0 || j == 0) {
                d[i][j] = i + j;
                continue;
            }
            const std::size_t replaced = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, replaced});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
    return d[a.size()][b.size()];
}

struct Character {
    char32_t code;
    std::size_t bytes;
};

// The character that the text begins with; none where it is not UTF-8: cut short, longer than need be, a
// surrogate or past U+10FFFF (The Unicode Standard, 15.0, 2022, table 3-7).
std::optional<Character> first_character(std::string_view text) {
    constexpr std::array<char32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    if (byte(0) < 0x80) return Character{byte(0), 1};
    const std::size_t bytes = byte(0) >= 0xf0 ? 4 : byte(0) >= 0xe0 ? 3 : 2;
    if (byte(0) < 0xc0 || byte(0) > 0xf7 || text.size() < bytes) return std::nullopt;
    char32_t code = byte(0) & (0x7fU >> bytes);
    for (std::size_t i = 1; i < bytes; ++i) {
        if ((byte(i) & 0xc0) != 0x80) return std::nullopt;
        code = code << 6 | (byte(i) & 0x3fU);
    }
    const bool surrogate = 0xd800 <= code && code <= 0xdfff;
    if (code < least[bytes] || code > 0x10ffff || surrogate) return std::nullopt;
    return Character{code, bytes};
}

bool is_control(char32_t code) {
    return code < 0x20 || (0x7f <= code && code < 0xa0);
}

std::string escaped(std::string_view bytes) {
    constexpr std::string_view digits = "0123456789abcdef";
    if (bytes == "\n") return "\\n";
    std::string result;
    for (const char c : bytes) {
        const auto byte = static_cast<unsigned char>(c);
        result += {'\\', 'x', digits[byte >> 4], digits[byte & 15]};
    }
    return result;
}

std::string fit_for_a_message(std::string_view text, std::size_t longest) {
    std::string result;
    std::size_t shown = 0;
    while (shown < text.size()) {
        const std::string_view rest = text.substr(shown);
        const auto character = first_character(rest);
        const std::string_view bytes = rest.substr(0, character ? character->bytes : 1);
        if (shown + bytes.size() > longest) return result + "...";
        result += character && !is_control(character->code) ? std::string(bytes) : escaped(bytes);
        shown += bytes.size();
    }
    return result;
}

}  // namespace

std::string suggestion(std::string_view word, const std::vector<std::string_view>& known) {
    if (word.size() > longest_compared) return "";
    std::string_view nearest;
    std::size_t least = std::string_view::npos;
    for (const std::string_view each : known) {
        const std::size_t changes = distance(word, each);
        if (changes >= least) continue;
        least = changes;
        nearest = each;
    }
    return 3 * least <= std::max(word.size(), nearest.size()) ? std::string(nearest) : "";
}

std::string printable(std::string_view text) {
    return fit_for_a_message(text, longest_shown);
}

std::string one_line(std::string_view text) {
    return fit_for_a_message(text, text.size());
}

std::string in_gnuplot_quotes(std::string_view text) {
    std::string result(1, '\'');
    for (const char c : text) result.append(c == '\'' ? 2 : 1, c);
    return result + '\'';
}

bool is_plain(std::string_view text) {
    while (!text.empty()) {
        const auto character = first_character(text);
        if (!character || is_control(character->code)) return false;
        text.remove_prefix(character->bytes);
    }
    return true;
}

}  // namespace ropesim
