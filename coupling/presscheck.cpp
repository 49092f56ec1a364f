#include "coupling/commands/command_line.hpp"
#include "coupling/commands/commands.hpp"
#include "coupling/elastic/session.hpp"
#include "dem/expect.hpp"

#include <csignal>
#include <exception>
#include <iostream>
#include <string_view>

/// The program `presscheck`. Exit status: 0 done, 1 a calculation failed or a guard tripped, 2 the
/// input is wrong, 130 interrupted. An error is one line on standard error.
int main(int argc, char** argv) {
  // A limit on file sizes shall arrive as a failed write, not as a signal.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    // Ranks of a study share its runs and know nothing of MPI.
    bool const shares_runs = argc > 1 && std::string_view(argv[1]) == "study";
    if (!shares_runs && coupling::help_first_rank())
      return coupling::commands::done;
    return coupling::commands::run_command_line(argc, argv);
  } catch (dem::InvalidInput const& error) {
    std::cerr << error.what() << '\n';
    return coupling::commands::wrong_input;
  } catch (std::exception const& error) {
    std::cerr << error.what() << '\n';
    return coupling::commands::failed;
  }
}
