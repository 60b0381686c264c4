#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace ropesim {

// What a batch asks the scheduler (Slurm) for, beside its jobs; "" leaves it to the scheduler.
struct BatchRequest {
    long shards = 1;
    std::string partition;
    std::string time;  // limit of each task, such as 1:00:00
};

// A job of a batch: a script that the scheduler runs, once or once for every shard.
struct BatchJob {
    std::string name;                   // of the script, without ".sh"
    std::string purpose;                // a sentence in it
    bool of_every_shard = false;        // an array: ${SLURM_ARRAY_TASK_ID} is the shard
    std::vector<std::string> commands;  // lines of shell; the first that fails ends it
    bool after_success = false;         // of the job before it, and not after its end, however it ended
};

// The text as one word of a shell.
std::string shell_word(const std::string& text);

// The running program, as a word that names it on every machine that shares its file system.
std::string this_program();

// The job's script, to be submitted in the folder that it is in: sbatch <name>.sh
std::string batch_script(const BatchJob& job, const BatchRequest& request);

// Throws std::runtime_error, which names what to do `instead`, where there is no sbatch.
void require_sbatch(const std::string& instead);

// Writes the scripts into the folder and submits them from there, each to wait for the one before it. Gives
// the scheduler's numbers of the jobs. Throws std::runtime_error where one is not accepted; those before it
// are then cancelled.
std::vector<std::string> submit(const std::vector<BatchJob>& jobs, const BatchRequest& request,
                                const std::filesystem::path& folder);

// What `submit` would write and do, to read.
std::string dry_run(const std::vector<BatchJob>& jobs, const BatchRequest& request,
                    const std::filesystem::path& folder);

}  // namespace ropesim
