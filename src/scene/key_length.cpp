#include "scene/key_length.h"

#include <algorithm>

namespace ropesim {
namespace {

bool is_in_bare_key(char c) {
    return ('a' <= c && c <= 'z') || ('A' <= c && c <= 'Z') || ('0' <= c && c <= '9') || c == '-' || c == '_';
}

// How long the string is that the text begins with, quotes included: "", '', """ or '''.
std::size_t string_length(std::string_view text) {
    const char quote = text[0];
    const std::string_view three = text.substr(0, 3);
    const bool has_lines = three.size() == 3 && three[1] == quote && three[2] == quote;
    const std::string_view end = has_lines ? three : text.substr(0, 1);
    for (std::size_t i = end.size(); i < text.size(); ++i) {
        if (text.substr(i).starts_with(end)) return i + end.size();
        if (quote == '"' && text[i] == '\\') ++i;
    }
    return text.size();
}

// How long the comment, string or character is that the text begins with.
std::size_t token_length(std::string_view text) {
    if (text[0] == '#') return std::min(text.find('\n'), text.size());
    return text[0] == '"' || text[0] == '\'' ? string_length(text) : 1;
}

Place place_of(std::string_view before) {
    const std::size_t newline = before.rfind('\n');
    const auto lines = static_cast<std::size_t>(std::ranges::count(before, '\n'));
    return {lines + 1, before.size() - (newline == before.npos ? 0 : newline + 1) + 1};
}

}  // namespace

std::optional<Place> overlong_key(std::string_view toml) {
    std::size_t dots = 0;
    for (std::size_t i = 0; i < toml.size(); i += token_length(toml.substr(i))) {
        const char c = toml[i];
        if (c == '.' && ++dots == most_key_parts) return place_of(toml.substr(0, i));
        const bool goes_on = c == '.' || c == '"' || c == '\'' || c == ' ' || c == '\t' || is_in_bare_key(c);
        if (!goes_on) dots = 0;
    }
    return std::nullopt;
}

}  // namespace ropesim
