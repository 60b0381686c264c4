#pragma once

#include <functional>

namespace CLI {
class App;
}

namespace ropesim {

// What a subcommand does once its options are read; gives the exit status.
using Command = std::function<int()>;

// Each adds its options to the subcommand and gives what runs it.
Command render_command(CLI::App& app);
Command simulate_command(CLI::App& app);
Command compare_command(CLI::App& app);
Command study_command(CLI::App& app);
Command plan_command(CLI::App& app);
Command sweep_command(CLI::App& app);
Command submit_command(CLI::App& app);
Command diff_command(CLI::App& app);
Command verify_command(CLI::App& app);
Command methods_command(CLI::App& app);
Command scenes_command(CLI::App& app);
Command doctor_command(CLI::App& app);

}  // namespace ropesim
