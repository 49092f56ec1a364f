#pragma once

#include "coupling/case_file.hpp"

#include <filesystem>
#include <string>
#include <vector>

/// The sub-commands of `presscheck`. Each returns the exit status (0 done, 130 interrupted) or
/// throws: dem::InvalidInput for status 2, everything else for status 1.
namespace coupling::commands {

inline constexpr int done = 0;
inline constexpr int failed = 1;
inline constexpr int wrong_input = 2;
inline constexpr int interrupted = 130;

/// Which case, as it was asked for.
struct CaseChoice {
  std::filesystem::path file;
  std::vector<std::string> overrides; ///< "Section/Entry=value"
  std::string setup;                  ///< row of the table of set-ups beside the case; empty = none
};

struct RunOptions {
  CaseChoice choice;
  std::filesystem::path folder; ///< empty: runs/<case>
  int threads = 0;              ///< 0: as OpenMP finds
  std::string until;            ///< last stage to run; empty = all
  bool overwrite = false;
  bool quiet = false;
};

struct ResumeOptions {
  std::filesystem::path folder; ///< a run folder, or one restart file in it
  int threads = 0;
  std::string until;
  bool quiet = false;
};

struct CompareOptions {
  std::vector<std::filesystem::path> sources;
  std::filesystem::path file; ///< empty: comparison.html
};

int run(RunOptions const& options);
int check(CaseChoice const& choice);
int resume(ResumeOptions const& options);
int compare(CompareOptions const& options);
int report(std::filesystem::path const& folder);
int defaults(DefaultsFormat format);
int verify(std::string const& filter);

} // namespace coupling::commands
