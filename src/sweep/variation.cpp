#include "sweep/variation.h"

#include "scene/words.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>

namespace ropesim {
namespace {

constexpr long most_values = 100'000;

// Cuts at a mark that stands outside of quotes, brackets and braces.
std::vector<std::string_view> parts(std::string_view text, char mark) {
    std::vector<std::string_view> result;
    int depth = 0;
    char quote = 0;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (quote != 0)
            quote = c == quote ? '\0' : quote;
        else if (c == '"' || c == '\'')
            quote = c;
        else if (c == '[' || c == '{')
            ++depth;
        else if (c == ']' || c == '}')
            --depth;
        else if (c == mark && depth == 0) {
            result.push_back(text.substr(begin, i - begin));
            begin = i + 1;
        }
    }
    result.push_back(text.substr(begin));
    return result;
}

// NaN where it is no number.
double number(std::string_view text) {
    double result = 0.0;
    const char* const begin = text.data();
    const char* const end = begin + text.size();
    const auto read = std::from_chars(begin, end, result);
    return read.ec == std::errc() && read.ptr == end ? result : std::nan("");
}

// A power may be rounded differently elsewhere, which these digits hide.
constexpr int all_digits = 12;
std::string rounded(double value, int digits) {
    std::array<char, 32> text;
    std::snprintf(text.data(), text.size(), "%.*g", digits, value);
    value = std::strtod(text.data(), nullptr);
    std::snprintf(text.data(), text.size(), "%.*g", all_digits, value);
    return text.data();
}

struct ValueRange {
    double first;
    double last;
    long count;
    bool equal_ratios;

    std::string value(long i, bool whole) const {
        const double part = count == 1 ? 0.0 : static_cast<double>(i) / static_cast<double>(count - 1);
        const double exact =
            equal_ratios ? first * std::pow(last / first, part) : first + (last - first) * part;
        if (whole) return std::to_string(std::lround(exact));
        constexpr int enough = 4;  // digits
        return rounded(exact, equal_ratios && i > 0 && i < count - 1 ? enough : all_digits);
    }
};

ValueRange parse_range(const std::vector<std::string_view>& parts) {
    const bool equal_ratios = parts.size() == 4 && parts[3] == "log";
    if (parts.size() != 3 && !equal_ratios)
        throw std::runtime_error("is no range; expected A:B:N, N values from A to B, or A:B:N:log");
    const double first = number(parts[0]);
    const double last = number(parts[1]);
    const double count = number(parts[2]);
    if (!std::isfinite(first) || !std::isfinite(last))
        throw std::runtime_error("is no range; expected A:B:N with numbers A and B");
    if (!(count >= 1 && count <= most_values && count == std::trunc(count)))
        throw std::runtime_error("asks for " + printable(parts[2]) + " values, expected 1 to " +
                                 std::to_string(most_values));
    if (equal_ratios && !(first > 0.0 && last > 0.0))
        throw std::runtime_error("has no equal ratios; expected A and B above 0");
    return {first, last, std::lround(count), equal_ratios};
}

std::vector<std::string> values_of(std::string_view text, bool whole) {
    std::vector<std::string> values;
    if (const auto colons = parts(text, ':'); colons.size() > 1) {
        const ValueRange range = parse_range(colons);
        for (long i = 0; i < range.count; ++i) values.push_back(range.value(i, whole));
    } else {
        for (const std::string_view each : parts(text, ',')) values.emplace_back(each);
    }
    std::vector<std::string> sorted = values;
    std::sort(sorted.begin(), sorted.end());
    const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
    if (twice != sorted.end()) throw std::runtime_error("gives " + printable(*twice) + " twice");
    return values;
}

}  // namespace

Variation parse_variation(std::string_view text, const Scene& scene) {
    const std::size_t equals = text.find('=');
    if (equals == std::string_view::npos || equals == 0)
        throw std::runtime_error("'" + printable(text) +
                                 "': expected KEY=A:B:N or KEY=V1,V2,..., such as stiffness=10:1000:5:log");
    Variation variation{std::string(text.substr(0, equals)), {}};
    try {
        variation.values = values_of(text.substr(equals + 1), takes_whole_numbers(variation.key));
        for (const std::string& value : variation.values) {
            Scene tried = scene;
            set_key(tried, variation.key, value);
        }
    } catch (const std::runtime_error& error) {
        throw std::runtime_error("'" + printable(text) + "': " + error.what());
    }
    return variation;
}

}  // namespace ropesim
