#pragma once

#include <sys/resource.h>
#include <sys/types.h>
#include <filesystem>
#include <string>
#include <vector>

namespace ropesim {

// What a run of the program left.
struct Outcome {
    int status;  // exit status; 128 + signal where one ended it
    std::string out;
    std::string err;
};

// Runs the program with these arguments in the folder, and with at most so many bytes of addresses.
Outcome ropesim(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
                rlim_t addresses = RLIM_INFINITY);

// The same with a standard output that can hold nothing, as on a full disk.
Outcome ropesim_with_full_output(const std::filesystem::path& folder,
                                 const std::vector<std::string>& arguments);

// Starts it without waiting; its output goes to nobody.
pid_t start_ropesim(const std::filesystem::path& folder, const std::vector<std::string>& arguments);

// Waits for it; the status as in Outcome.
int wait_for(pid_t process);

}  // namespace ropesim
