#include "clip/file.h"
#include "clip/folder_lock.h"
#include "commands/commands.h"
#include "diff/accept.h"
#include "diff/cause.h"
#include "diff/compare.h"
#include "diff/machine.h"
#include "diff/report.h"
#include "diff/summary.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <limits>
#include <memory>
#include <optional>

namespace ropesim {
namespace {

struct DiffOptions {
    std::string expected;
    std::string actual;
    Tolerance tolerance;
    std::string report;
    std::string json;
    std::string junit;
    bool accept = false;
};

void add_options(CLI::App& app, DiffOptions& options) {
    app.add_option("EXPECTED", options.expected, "a PNG file, or a folder of them")
        ->required()
        ->type_name("");
    app.add_option("ACTUAL", options.actual, "what to compare with it")->required()->type_name("");
    app.add_option("--threshold", options.tolerance.channel,
                   "a pixel counts where a channel differs by more than this, of 255")
        ->type_name("T")
        ->check(CLI::Range(0, 255).description(""))
        ->capture_default_str();
    app.add_option("--max-pixels", options.tolerance.pixels,
                   "as many pixels may count in a frame that passes")
        ->type_name("P")
        ->check(CLI::Range(0L, std::numeric_limits<long>::max()).description(""))
        ->capture_default_str();
    app.add_option("--report", options.report, "write an HTML page to look at, pictures included")
        ->type_name("FILE");
    app.add_option("--json", options.json, "write what was found, for programs")->type_name("FILE");
    app.add_option("--junit", options.junit, "write it as JUnit XML, each frame a test")->type_name("FILE");
    app.add_flag("--accept", options.accept, "copy the frames of ACTUAL that fail over those of EXPECTED");
    app.footer(
        "Exit status: 0 the same, 3 they differ, 1 could not compare, 2 wrong usage.\n"
        "Examples:\n"
        "  ropesim diff golden frames --report diff.html\n"
        "  ropesim diff golden frames --threshold 0         every bit of every pixel");
}

void check_reports(const DiffOptions& options) {
    for (const std::string& file : {options.report, options.json, options.junit})
        if (!file.empty()) check_writable(file);
}

void write_reports(const DiffOptions& options, const Comparison& comparison, const Cause& cause) {
    if (!options.report.empty()) write_file(options.report, to_html(comparison, cause), Place::named);
    if (!options.json.empty()) write_file(options.json, to_json(comparison, cause), Place::named);
    if (!options.junit.empty()) write_file(options.junit, to_junit(comparison, cause), Place::named);
}

// Says what it does; 0 where nothing that differs is left.
int accept_all(const Comparison& comparison) {
    const Accepted accepted = accept(comparison);
    for (const std::string& line : accepted.done) std::printf("accepted: %s\n", line.c_str());
    for (const std::string& line : accepted.left) std::printf("left: %s\n", line.c_str());
    return accepted.left.empty() ? 0 : status(comparison);
}

// Where a path's files are.
std::filesystem::path folder_of(const std::filesystem::path& path) {
    if (std::filesystem::is_directory(path)) return path;
    return path.has_parent_path() ? path.parent_path() : ".";
}

int diff(const DiffOptions& options) {
    check_reports(options);
    std::optional<FolderLock> lock;  // before the look at what will be replaced
    if (options.accept) lock.emplace(folder_of(options.expected), "");
    Comparison comparison = compare(options.expected, options.actual, options.tolerance);
    const Cause why = cause(comparison);
    excuse_chaos(why, comparison);
    if (comparison.folders) std::fputs(frame_lines(comparison).c_str(), stdout);
    for (const std::string& sentence : why.sentences) std::printf("why: %s\n", sentence.c_str());
    std::printf("%s\n", headline(comparison).c_str());
    write_reports(options, comparison, why);
    return options.accept ? accept_all(comparison) : status(comparison);
}

}  // namespace

Command diff_command(CLI::App& app) {
    const auto options = std::make_shared<DiffOptions>();
    add_options(app, *options);
    return [options] { return diff(*options); };
}

}  // namespace ropesim
