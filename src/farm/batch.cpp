#include "farm/batch.h"

#include "clip/file.h"
#include "clip/process.h"

#include <stdexcept>

namespace ropesim {
namespace {

std::string script_name(const BatchJob& job) {
    return job.name + ".sh";
}

// The command that submits a job behind the job of that number ("" where it is the first).
std::vector<std::string> sbatch_command(const BatchJob& job, const std::string& before) {
    std::vector<std::string> command{"sbatch", "--parsable"};
    if (!before.empty()) {
        command.push_back(std::string("--dependency=") + (job.after_success ? "afterok:" : "afterany:") +
                          before);
        command.push_back("--kill-on-invalid-dep=yes");
    }
    command.push_back(script_name(job));
    return command;
}

// "1234" of "1234;cluster\n".
std::string job_number(const std::string& parsable) {
    return parsable.substr(0, parsable.find_first_of(";\n"));
}

}  // namespace

std::string shell_word(const std::string& text) {
    std::string word = "'";
    for (const char c : text) word += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return word + '\'';
}

std::string this_program() {
    return shell_word(std::filesystem::read_symlink("/proc/self/exe").string());
}

std::string batch_script(const BatchJob& job, const BatchRequest& request) {
    std::string text = "#!/bin/bash\n#SBATCH --job-name=ropesim-" + job.name + "\n";
    if (job.of_every_shard) text += "#SBATCH --array=0-" + std::to_string(request.shards - 1) + "\n";
    text += "#SBATCH --output=" + job.name + (job.of_every_shard ? "-%a" : "") + ".log\n";
    text += "#SBATCH --open-mode=append\n#SBATCH --ntasks=1\n#SBATCH --requeue\n";
    if (!request.partition.empty()) text += "#SBATCH --partition=" + request.partition + "\n";
    if (!request.time.empty()) text += "#SBATCH --time=" + request.time + "\n";
    text +=
        "# " + job.purpose + "\n# To submit it by hand, in this folder: sbatch " + script_name(job) + "\n";
    if (job.of_every_shard)
        text +=
            "# With another scheduler, put its array index, from 0 on, in place of SLURM_ARRAY_TASK_ID:\n"
            "# PBS_ARRAY_INDEX, $((SGE_TASK_ID - 1)), $((LSB_JOBINDEX - 1)).\n";
    text += "set -e\n";
    for (const std::string& command : job.commands) text += command + '\n';
    return text;
}

void require_sbatch(const std::string& instead) {
    if (!is_installed("sbatch"))
        throw std::runtime_error("no Slurm here: sbatch is not on the PATH; on this machine alone: " +
                                 instead);
}

std::vector<std::string> submit(const std::vector<BatchJob>& jobs, const BatchRequest& request,
                                const std::filesystem::path& folder) {
    for (const BatchJob& job : jobs) write_file(folder / script_name(job), batch_script(job, request));
    std::vector<std::string> numbers;
    try {
        for (const BatchJob& job : jobs)
            numbers.push_back(
                job_number(run_program(sbatch_command(job, numbers.empty() ? "" : numbers.back()), folder)));
    } catch (const std::runtime_error&) {
        std::vector<std::string> cancel{"scancel"};
        cancel.insert(cancel.end(), numbers.begin(), numbers.end());
        if (!numbers.empty()) run_program(cancel, folder);
        throw std::runtime_error("Slurm does not take " +
                                 (folder / script_name(jobs[numbers.size()])).string() +
                                 "; nothing was submitted");
    }
    return numbers;
}

std::string dry_run(const std::vector<BatchJob>& jobs, const BatchRequest& request,
                    const std::filesystem::path& folder) {
    std::string text;
    for (const BatchJob& job : jobs)
        text += "==> " + (folder / script_name(job)).string() + " <==\n" + batch_script(job, request) + '\n';
    std::string before;
    for (const BatchJob& job : jobs) {
        std::string line = "$";
        for (const std::string& word : sbatch_command(job, before)) line += ' ' + word;
        text += line + '\n';
        before = '<' + job.name + '>';
    }
    return text;
}

}  // namespace ropesim
