#pragma once

namespace coupling::commands {

/// Reads the command line and runs the sub-command. @returns the exit status; an error of the
/// command line is one line on standard error and status 2. @throws what the sub-command throws
int run_command_line(int argc, char const* const* argv);

} // namespace coupling::commands
