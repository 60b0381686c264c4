#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace ropesim {

// The known word that is nearest to a misspelt one, or "" where none is near: at most a third of its
// letters must be inserted, deleted, replaced or swapped with their neighbour (optimal string alignment).
std::string suggestion(std::string_view word, const std::vector<std::string_view>& known);

// The text with control characters and bytes that are not UTF-8 written as \n, \x1b, ...: fit for a terminal.
std::string one_line(std::string_view text);

// The same, cut after 60 bytes, between characters: fit to stand in a message.
std::string printable(std::string_view text);

// The text as gnuplot takes it to the letter: in single quotes, where neither ` nor \ nor " means anything.
std::string in_gnuplot_quotes(std::string_view text);

// Whether a text is UTF-8 without control characters.
bool is_plain(std::string_view text);

}  // namespace ropesim
