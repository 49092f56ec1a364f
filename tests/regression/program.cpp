#include "tests/regression/program.hpp"

#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <stdexcept>

namespace program {
namespace {

std::vector<char*> argument_pointers(std::vector<std::string>& words) {
  std::vector<char*> pointers;
  for (auto& word : words)
    pointers.push_back(word.data());
  pointers.push_back(nullptr);
  return pointers;
}

std::string contents(int file) {
  std::string text;
  std::array<char, 4096> block;
  lseek(file, 0, SEEK_SET);
  for (ssize_t n; (n = read(file, block.data(), block.size())) > 0;)
    text.append(block.data(), static_cast<std::size_t>(n));
  return text;
}

} // namespace

Running::Running(std::vector<std::string> const& arguments) {
  std::array<int, 2> pipe_ends;
  out_ = memfd_create("standard output", 0);
  if (out_ < 0 || pipe(pipe_ends.data()) != 0)
    throw std::runtime_error("no pipe");
  std::vector<std::string> words{PRESSCHECK_PROGRAM};
  words.insert(words.end(), arguments.begin(), arguments.end());
  if (words.size() > 1 && words[1] == "sh")
    words.erase(words.begin());
  process_ = fork();
  if (process_ == 0) {
    dup2(out_, STDOUT_FILENO);
    dup2(pipe_ends[1], STDERR_FILENO);
    close(pipe_ends[0]);
    close(pipe_ends[1]);
    auto const pointers = argument_pointers(words);
    execvp(pointers[0], pointers.data());
    _exit(127);
  }
  close(pipe_ends[1]);
  error_ = pipe_ends[0];
}

Running::~Running() {
  if (process_ > 0) {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  close(out_);
  close(error_);
}

bool Running::read_error() {
  std::array<char, 4096> block;
  ssize_t const n = read(error_, block.data(), block.size());
  if (n > 0)
    error_text_.append(block.data(), static_cast<std::size_t>(n));
  return n > 0;
}

bool Running::wait_for(std::string const& text) {
  while (error_text_.find(text) == std::string::npos)
    if (!read_error())
      return false;
  return true;
}

void Running::signal(int number) {
  kill(process_, number);
}

Outcome Running::finish() {
  while (read_error()) {
  }
  int status = 0;
  waitpid(process_, &status, 0);
  process_ = -1;
  return {.status = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status),
          .out = contents(out_),
          .error = error_text_};
}

Outcome run(std::vector<std::string> const& arguments) {
  return Running(arguments).finish();
}

Outcome run_after(std::string const& preparation, std::vector<std::string> const& arguments) {
  std::string line = preparation + " && exec \"" PRESSCHECK_PROGRAM "\"";
  for (auto const& word : arguments)
    line += " '" + word + "'";
  return run({"sh", "-c", line});
}

std::string tiny_case() {
  return PRESSCHECK_SOURCE_DIR "/tests/regression/tiny/case.prm";
}

} // namespace program
