#pragma once

namespace coupling::study {

/// Where this process stands among those that a launcher (mpirun, srun) started.
struct BatchRank {
  int rank = 0;
  int size = 1;

  bool is_one_of_several() const { return size > 1; }
};

/// From the variables that Open MPI, MPICH and Slurm set; MPI itself is not started.
BatchRank batch_rank();

} // namespace coupling::study
