// Launch: number of processes that a launcher (mpirun, srun) has started, from the environment.
// Processes that are not joined by MPI would each do the whole work and write the same files.
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace kusabi::run {

/// Value of an environment variable; null if it is not set. std::getenv, except in tests.
using Environment = std::function<const char*(const char* name)>;

struct Launch {
  std::string by;                ///< name of the variable
  unsigned processes = 1;        ///< processes started together, including this one
  unsigned number = 0;           ///< index of this process, from 0
  bool step_of_a_batch = false;  ///< started by srun, which also starts programs without MPI
};

/// Launch of this process. Open MPI sets OMPI_COMM_WORLD_SIZE, launchers of the MPICH family set
/// PMI_SIZE. srun is considered only without these, since mpirun may use it to start its daemons.
/// An allocation (salloc, a batch script) also has SLURM_NTASKS, but only processes started by srun
/// have both SLURM_STEP_ID and SLURM_PROCID, and the interactive step of salloc has a special
/// number.
/// @return nothing without a launcher
std::optional<Launch> launch_from(const Environment& environment);

/// Error message if the launch and the number of MPI ranks disagree.
/// @param serial true if the call has --serial: steps of a batch system may then run independent
///        searches; mpirun may not
/// @return nothing if they agree
std::optional<std::string> fault_of_launch(const std::optional<Launch>& launch, unsigned ranks,
                                           bool serial);

}  // namespace kusabi::run
