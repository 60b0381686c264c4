#pragma once

#include <filesystem>
#include <string>

namespace ropesim {

// Throws std::runtime_error, with what to install, where there is no gnuplot.
void require_gnuplot();

// Writes the script as <name>.gp into the folder and lets gnuplot draw <name>.png and <name>.svg by it there.
// Throws std::runtime_error where it cannot.
void draw_chart(const std::filesystem::path& folder, const std::string& name, const std::string& script);

}  // namespace ropesim
