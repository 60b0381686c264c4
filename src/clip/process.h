#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace ropesim {

// Whether a program of that name is on the PATH.
bool is_installed(const std::string& program);

// Runs a program in a folder, without a shell. `feed` writes to its standard input by calling what it is
// given (bytes); its standard output is returned. Throws std::runtime_error where it cannot be started or
// fails; it has said why on stderr. Where `feed` throws, the program is killed first.
std::string run_program(const std::vector<std::string>& command, const std::filesystem::path& folder,
                        const std::function<void(const std::function<void(std::string_view)>& write)>& feed);

// The same for a program that is given no input.
std::string run_program(const std::vector<std::string>& command, const std::filesystem::path& folder);

}  // namespace ropesim
