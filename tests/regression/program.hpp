#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// Runs the program `presscheck` as a user would.
namespace program {

struct Outcome {
  int status;        ///< exit status; 128 + signal if it was killed
  std::string out;   ///< standard output
  std::string error; ///< standard error
};

/// A running presscheck whose standard error can be followed.
class Running {
public:
  explicit Running(std::vector<std::string> const& arguments);
  ~Running();
  Running(Running const&) = delete;
  Running& operator=(Running const&) = delete;

  /// Reads standard error until it contains `text`. @returns false if the program ended before
  bool wait_for(std::string const& text);
  void signal(int number);
  Outcome finish();

private:
  bool read_error();

  int process_ = -1;
  int out_ = -1;   // the file that collects standard output, unlinked
  int error_ = -1; // reading end of a pipe
  std::string error_text_;
};

Outcome run(std::vector<std::string> const& arguments);

/// The same after a shell has prepared the ground: `ulimit -f 8`.
Outcome run_after(std::string const& preparation, std::vector<std::string> const& arguments);

/// tests/regression/tiny/case.prm
std::string tiny_case();

} // namespace program
