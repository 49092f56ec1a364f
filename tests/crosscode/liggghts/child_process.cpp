#include "tests/crosscode/liggghts/child_process.hpp"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

namespace crosscode {
namespace {

double seconds(timeval const& t) {
  return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
}

/// In the child. Only returns by ending the process: the parent reads 127 as "could not be
/// started".
[[noreturn]] void become(std::vector<char*> const& arguments, std::filesystem::path const& folder,
                         int threads) {
  int const out =
      chdir(folder.c_str()) == 0 ? open("output.txt", O_WRONLY | O_CREAT | O_TRUNC, 0644) : -1;
  if (out < 0 || dup2(out, STDOUT_FILENO) < 0 || dup2(out, STDERR_FILENO) < 0)
    _exit(127);
  setenv("OMP_NUM_THREADS", std::to_string(threads).c_str(), 1);
  execv(arguments.front(), arguments.data());
  _exit(127);
}

} // namespace

ProcessCost run_program(std::vector<std::string> const& command,
                        std::filesystem::path const& folder, int threads) {
  std::vector<char*> arguments;
  for (std::string const& word : command)
    arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  auto const start = std::chrono::steady_clock::now();
  pid_t const child = fork();
  if (child < 0)
    throw std::runtime_error(command.front() + ": no process can be started");
  if (child == 0)
    become(arguments, folder, threads);
  int status = 0;
  rusage usage{};
  if (wait4(child, &status, 0, &usage) != child)
    throw std::runtime_error(command.front() + ": lost while running");
  std::chrono::duration<double> const wall = std::chrono::steady_clock::now() - start;
  int const code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  if (code == 127)
    throw std::runtime_error(command.front() + ": cannot be started. Is it built and executable?");
  return {.exit_status = code,
          .cpu_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime),
          .wall_seconds = wall.count(),
          .largest_memory = 1024.0 * static_cast<double>(usage.ru_maxrss)};
}

std::string find_program(std::string const& name, std::string const& debian_package) {
  char const* const path = std::getenv("PATH");
  std::istringstream folders(path ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (auto const file = std::filesystem::path(folder) / name; access(file.c_str(), X_OK) == 0)
      return file;
  throw std::runtime_error(
      fmt::format("{} is not installed (this test compares with the real program). "
                  "apt-get install --no-install-recommends {}?",
                  name, debian_package));
}

} // namespace crosscode
