#pragma once

#include "farm/batch.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace ropesim {

// The options of everything that is handed to a scheduler.
struct BatchOptions {
    BatchRequest request;
    bool dry_run = false;
};

void add_batch_options(CLI::App& app, BatchOptions& options);

// Submits the jobs and says so, or prints them under --dry-run. Their scripts, logs and the scene are in
// `folder`.
void hand_over(const BatchOptions& options, const std::vector<BatchJob>& jobs,
               const std::filesystem::path& folder, const std::string& scene_toml);

}  // namespace ropesim
