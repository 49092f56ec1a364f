#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace crosscode {

/// What a finished program cost.
struct ProcessCost {
  int exit_status;    ///< 128 + signal if it was killed
  double cpu_seconds; ///< user + system, all its threads
  double wall_seconds;
  double largest_memory; ///< [bytes], peak resident set
};

/// Runs a program in `folder`, waits for it; its output and errors go to `folder`/output.txt.
/// `threads` is what OpenMP may use.
/// @throws std::runtime_error if it cannot be started, naming it
ProcessCost run_program(std::vector<std::string> const& command,
                        std::filesystem::path const& folder, int threads = 1);

/// Full path of a program on PATH. @throws std::runtime_error naming the Debian package to install
std::string find_program(std::string const& name, std::string const& debian_package);

} // namespace crosscode
