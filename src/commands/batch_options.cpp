#include "commands/batch_options.h"

#include "clip/file.h"
#include "scene/words.h"

#include <CLI/CLI.hpp>

#include <cstdio>

namespace ropesim {
namespace {

constexpr const char* word_of_slurm = "expected letters, digits and .,:_- only";

std::string check_word(const std::string& text) {
    const bool fit = !text.empty() && text.find_first_not_of(
                                          "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                          "0123456789.,:_-") == std::string::npos;
    return fit ? "" : word_of_slurm;
}

}  // namespace

void add_batch_options(CLI::App& app, BatchOptions& options) {
    app.add_option("--shards", options.request.shards, "tasks that share the work")
        ->type_name("N")
        ->check(CLI::Range(1L, 100'000L).description(""))
        ->capture_default_str();
    app.add_option("--partition", options.request.partition, "Slurm's partition; its default without it")
        ->type_name("P")
        ->check(check_word);
    app.add_option("--time", options.request.time, "time limit of each task, such as 1:30:00")
        ->type_name("T")
        ->check(check_word);
    app.add_flag("--dry-run", options.dry_run, "print the batch scripts and submit nothing");
}

void hand_over(const BatchOptions& options, const std::vector<BatchJob>& jobs,
               const std::filesystem::path& folder, const std::string& scene_toml) {
    if (options.dry_run) {
        std::printf("%s", dry_run(jobs, options.request, folder).c_str());
        return;
    }
    make_folder(folder.parent_path());
    make_folder(folder);
    write_file(folder / "scene.toml", scene_toml);
    const std::vector<std::string> numbers = submit(jobs, options.request, folder);
    for (std::size_t i = 0; i < jobs.size(); ++i)
        std::printf(
            "job %s: %s.sh%s\n", numbers[i].c_str(), jobs[i].name.c_str(),
            jobs[i].of_every_shard ? (", " + std::to_string(options.request.shards) + " tasks").c_str() : "");
    std::printf("scripts and logs in %s/; all is done when job %s is\n", one_line(folder.string()).c_str(),
                numbers.back().c_str());
}

}  // namespace ropesim
