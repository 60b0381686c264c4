#include "commands/commands.h"
#include "simulation/method.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdio>
#include <string>

namespace ropesim {
namespace {

std::string limit(const Method& method) {
    if (std::isinf(method.stability_limit)) return "none";
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", method.stability_limit);
    return text;
}

int list() {
    std::printf("%-22s %-13s %5s  %-9s %-5s  %s\n", "method", "model", "order", "h*omega <", "keeps", "for");
    for (const Method& method : methods())
        std::printf("%-22s %-13s %5d  %-9s %-5s  %s\n", std::string(method.name).c_str(),
                    std::string(name(method.model)).c_str(), method.order, limit(method).c_str(),
                    letters(method.keeps).c_str(), std::string(method.purpose).c_str());
    return 0;
}

}  // namespace

Command methods_command(CLI::App& app) {
    app.footer(
        "h*omega < is the stability limit, undamped: step times the greatest angular frequency of the rope,\n"
        "at most 2 sqrt(stiffness / mass); 0: no step is stable, none: every step is.\n"
        "keeps, of an undamped rope: s the symplectic form, and so its energy without drift; r the way "
        "back,\n"
        "when velocities are negated; m momentum; a angular momentum.\n"
        "Example: ropesim methods");
    return [] { return list(); };
}

}  // namespace ropesim
