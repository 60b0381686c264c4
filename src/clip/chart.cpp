#include "clip/chart.h"

#include "clip/file.h"
#include "clip/process.h"

#include <stdexcept>

namespace ropesim {

void require_gnuplot() {
    if (!is_installed("gnuplot"))
        throw std::runtime_error(
            "charts need gnuplot, which is not installed; try: apt-get install gnuplot-nox");
}

void draw_chart(const std::filesystem::path& folder, const std::string& name, const std::string& script) {
    const std::string file = name + ".gp";
    write_file(folder / file, script);
    run_program({"gnuplot", file}, folder);
}

}  // namespace ropesim
