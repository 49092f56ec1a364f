#pragma once

#include "coupling/case_file.hpp"

#include <cstdint>
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

struct StudyOptions {
  std::filesystem::path file;
  std::filesystem::path folder;  ///< empty: studies/<study>
  std::vector<std::string> only; ///< runs by name; empty: all
  std::string export_to;         ///< "slurm": write scripts instead of running
  int jobs = 0;                  ///< runs at once; 0: as many as there are cores for
  int threads = 0;               ///< of each run; 0: what the runs leave free
  bool dry_run = false;          ///< print the plan and stop
  bool collects = false;         ///< gather what there is and stop
  bool retries = false;          ///< try failed runs again
  bool overwrite = false;        ///< take over the folder of another study
  bool quiet = false;
  bool lists_entries = false;
};

struct DiagnoseOptions {
  CaseChoice choice;
  std::filesystem::path measured; ///< folder with measured.json
  std::filesystem::path folder;   ///< empty: diagnoses/<name of the measured folder>
  std::vector<std::filesystem::path> simulations; ///< run folders of the case; none: it is run
  int packings = 0; ///< to run; 0: four of a coarse bed, fewer of a fine one
  int threads = 0;
  std::uint64_t seed = 1;                     ///< of the references' draws
  double modulus_sd = 0.3, cohesion_sd = 0.5; ///< of the sheet's values, relative [1]
  bool is_quick = false; ///< the extended case is not run: gains are the emulator's
  bool overwrite = false;
  bool quiet = false;
};

int run(RunOptions const& options);
int check(CaseChoice const& choice);
int resume(ResumeOptions const& options);
int compare(CompareOptions const& options);
int diagnose(DiagnoseOptions const& options);
int report(std::filesystem::path const& folder);
int study(StudyOptions const& options);
int defaults(DefaultsFormat format);
int verify(std::string const& filter);

} // namespace coupling::commands
