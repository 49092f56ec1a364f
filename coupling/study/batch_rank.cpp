#include "coupling/study/batch_rank.hpp"

#include <array>
#include <cstdlib>
#include <string>

namespace coupling::study {
namespace {

struct Launcher {
  char const* rank;
  char const* size;
};

// A step of Slurm that starts mpirun sets its own, too: the inner launcher comes first.
constexpr std::array<Launcher, 3> launchers{{{"OMPI_COMM_WORLD_RANK", "OMPI_COMM_WORLD_SIZE"},
                                             {"PMI_RANK", "PMI_SIZE"},
                                             {"SLURM_PROCID", "SLURM_STEP_NUM_TASKS"}}};

} // namespace

BatchRank batch_rank() {
  for (auto const& launcher : launchers) {
    char const* const rank = std::getenv(launcher.rank);
    char const* const size = std::getenv(launcher.size);
    if (rank == nullptr || size == nullptr)
      continue;
    int const r = std::atoi(rank), n = std::atoi(size);
    if (n > 1 && r >= 0 && r < n)
      return {r, n};
  }
  return {};
}

} // namespace coupling::study
