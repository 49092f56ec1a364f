#pragma once

#include "coupling/commands/commands.hpp"
#include "coupling/finding/extended_case.hpp"
#include "coupling/measured/measured_data.hpp"
#include "coupling/reduced/simulated_press.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace coupling::commands {

/// A run that did not come to its end.
struct Stopped {
  int status; ///< for the shell
};

/// Simulations of cases as far as measured runs were pressed, in the folder of a diagnosis. What
/// the constructor refers to outlives it.
class CaseRuns {
public:
  CaseRuns(measured::MeasuredData const& data, DiagnoseOptions const& options,
           std::filesystem::path folder)
      : data_(data), options_(options), folder_(std::move(folder)) {}

  /// Runs packings of a case in the folders `name`, `name`_2, ...: as many as the options say, or
  /// as many as have the grains of a bed that scatters by half a per cent, at most four.
  /// @throws Stopped, dem::InvalidInput
  std::vector<std::filesystem::path> simulate(CaseChoice const& choice, std::string const& name);

  /// The press that `name`.prm is; the same entries are simulated once.
  /// @throws Stopped, dem::InvalidInput
  reduced::SimulatedPress press_of(std::string const& name, finding::ExtendedCase const& what);

private:
  measured::MeasuredData const& data_;
  DiagnoseOptions const& options_;
  std::filesystem::path folder_;
  std::map<std::string, reduced::SimulatedPress> presses_; ///< by their entries
};

} // namespace coupling::commands
