#include "coupling/study/slurm_export.hpp"

#include "coupling/record/atomic_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace coupling::study {
namespace {

namespace fs = std::filesystem;

// An estimate may be wrong by two on another machine, and a task that runs out of time has to come
// back.
constexpr double time_margin = 3.0;
constexpr double memory_margin = 2.0;

/// A text as bash takes it for one word.
std::string quoted(std::string const& text) {
  std::string result = "'";
  for (char const c : text)
    result += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return result + "'";
}

std::string hours(double seconds) {
  auto const minutes = static_cast<long>(std::ceil(std::max(600.0, seconds) / 60.0));
  return fmt::format("{:02d}:{:02d}:00", minutes / 60, minutes % 60);
}

void write_script(fs::path const& file, std::string const& text) {
  write_file(file, "#!/usr/bin/env bash\n" + text);
  fs::permissions(file, fs::perms::owner_all | fs::perms::group_read | fs::perms::group_exec |
                            fs::perms::others_read | fs::perms::others_exec);
}

std::string call(BatchFolder const& folder, SlurmChoice const& choice) {
  return fmt::format("\"${{PRESSCHECK:-{}}}\" study {} -o {}", choice.program.string(),
                     quoted(fs::absolute(choice.study).string()), quoted(folder.path().string()));
}

std::string array_script(BatchFolder const& folder, std::vector<StudyRun> const& runs,
                         StudyCost const& cost, SlurmChoice const& choice) {
  auto text = fmt::format(
      "# One task a run; a task that is sent back or repeated goes on from its newest restart.\n"
      "# Longest run: about {:.2g} h on one processor; all: {:.3g} h.\n"
      "#SBATCH --job-name=presscheck-study\n"
      "#SBATCH --array=1-{}\n"
      "#SBATCH --ntasks=1\n"
      "#SBATCH --cpus-per-task={}\n"
      "#SBATCH --mem={}M\n"
      "#SBATCH --time={}\n"
      "#SBATCH --requeue\n"
      "#SBATCH --signal=B:TERM@120\n"
      "#SBATCH --output={}/slurm/%A_%a.log\n"
      "set -euo pipefail\n\nruns=(\n",
      cost.longest_cpu_seconds / 3600.0, cost.cpu_seconds / 3600.0, runs.size(), choice.threads,
      std::max(500L, std::lround(1e-6 * memory_margin * cost.largest_bytes)),
      hours(time_margin * cost.longest_cpu_seconds / choice.threads), folder.path().string());
  for (auto const& run : runs)
    text += "  " + quoted(run.id) + "\n";
  return text + fmt::format(")\n\n# exec: the warning before the time limit must reach presscheck, "
                            "which then writes a restart.\n"
                            "exec {} --only \"${{runs[SLURM_ARRAY_TASK_ID - 1]}}\" --threads {} "
                            "--quiet\n",
                            call(folder, choice), choice.threads);
}

std::string collect_script(BatchFolder const& folder, SlurmChoice const& choice) {
  return fmt::format("# Gathers results.csv and study.json after the array.\n"
                     "#SBATCH --job-name=presscheck-collect\n"
                     "#SBATCH --ntasks=1\n"
                     "#SBATCH --mem=1000M\n"
                     "#SBATCH --time=00:30:00\n"
                     "#SBATCH --output={}/slurm/collect.log\n"
                     "set -euo pipefail\nexec {} --collect\n",
                     folder.path().string(), call(folder, choice));
}

std::string submit_script(StudyCost const& cost, SlurmChoice const& choice) {
  return fmt::format(
      "# Submits the runs and, after them, the collection. What a site decides:\n"
      "#   ACCOUNT=...    account to charge (default: yours)\n"
      "#   PARTITION=...  partition (default: the site's)\n"
      "#   TIME={}  longest time of a run (three times the estimate)\n"
      "#   PRESSCHECK=... program, where it is another one on the nodes\n"
      "set -euo pipefail\ncd \"$(dirname \"$0\")\"\n\n"
      "options=(${{ACCOUNT:+--account=\"$ACCOUNT\"}} ${{PARTITION:+--partition=\"$PARTITION\"}})\n"
      "job=$(sbatch --parsable \"${{options[@]}}\" ${{TIME:+--time=\"$TIME\"}} --export=ALL "
      "array.sh)\n"
      "sbatch \"${{options[@]}}\" --dependency=afterany:\"${{job%%;*}}\" --export=ALL collect.sh\n",
      hours(time_margin * cost.longest_cpu_seconds / choice.threads));
}

} // namespace

fs::path export_slurm(BatchFolder const& folder, std::vector<StudyRun> const& runs,
                      std::vector<RunEstimate> const& estimates, SlurmChoice const& choice) {
  auto const place = folder.path() / "slurm";
  fs::create_directories(place);
  auto const cost = sum_costs(estimates);
  write_script(place / "array.sh", array_script(folder, runs, cost, choice));
  write_script(place / "collect.sh", collect_script(folder, choice));
  write_script(place / "submit.sh", submit_script(cost, choice));
  return place / "submit.sh";
}

} // namespace coupling::study
