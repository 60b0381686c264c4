#pragma once

#include <string>

namespace ropesim {

// A field of a CSV file; in quotes where it holds a comma or a quote (RFC 4180, 2.5 to 2.7).
std::string quoted(const std::string& field);

// The number with 17 significant digits, so that reading it gives the same double.
void append_number(std::string& text, double number);

}  // namespace ropesim
