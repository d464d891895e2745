// What a launcher (mpirun, srun) says of itself in the environment: how many processes of the
// command it has started. If they do not find each other, each would do the whole work and write
// the same files.
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace kusabi::run {

/// The value of an environment variable; null if it is not set. std::getenv, but for tests.
using Environment = std::function<const char*(const char* name)>;

struct Launch {
  std::string by;                ///< the variable that says how many
  unsigned processes = 1;        ///< that were started together, this one among them
  unsigned number = 0;           ///< of this one, from 0
  bool step_of_a_batch = false;  ///< by srun, which also starts programs that are no MPI job
};

/// How this process was started.
///
/// Open MPI's mpirun says so by OMPI_COMM_WORLD_SIZE, those of MPICH's family by PMI_SIZE; only
/// without these srun counts, since mpirun may use it to start its daemons. An allocation (salloc,
/// a batch script) has SLURM_NTASKS, too, but only a process that srun has started has
/// SLURM_STEP_ID with SLURM_PROCID, and the interactive step of salloc has a number of its own.
/// @return nothing if no launcher tells
std::optional<Launch> launch_told_by(const Environment& environment);

/// What is wrong if a process that was started so finds itself among `ranks`.
/// @param serial whether --serial is in the call: a step of a batch system may then run several
///        searches that have nothing to do with each other; mpirun may not
/// @return nothing if all is well
std::optional<std::string> fault_of_launch(const std::optional<Launch>& launch, unsigned ranks,
                                           bool serial);

}  // namespace kusabi::run
