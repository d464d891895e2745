// Environment variables of launchers, in order of precedence.
#include "run/session/launch.hpp"

#include <charconv>
#include <cstdint>
#include <string_view>

#include <fmt/format.h>

namespace kusabi::run {
namespace {

template <class Number>
std::optional<Number> number_in(const Environment& environment, const char* name) {
  const char* const text = environment(name);
  if (text == nullptr) return std::nullopt;
  const std::string_view digits(text);
  Number number{};
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
  return number;
}

std::optional<Launch> by_mpirun(const Environment& environment, const char* size,
                                const char* number) {
  const auto processes = number_in<unsigned>(environment, size);
  if (!processes) return std::nullopt;
  return Launch{size, *processes, number_in<unsigned>(environment, number).value_or(0), false};
}

std::optional<Launch> by_srun(const Environment& environment) {
  // Identifiers of special steps (interactive step, batch script, others not made by srun) are
  // numbered downwards from this value (slurm.h: SLURM_MAX_NORMAL_STEP_ID).
  constexpr std::uint64_t first_special_step = 0xfffffff0U;
  const auto step = number_in<std::uint64_t>(environment, "SLURM_STEP_ID");
  const auto number = number_in<unsigned>(environment, "SLURM_PROCID");
  if (!step || !number || *step >= first_special_step) return std::nullopt;
  for (const char* const size : {"SLURM_STEP_NUM_TASKS", "SLURM_NTASKS"}) {
    if (const auto processes = number_in<unsigned>(environment, size)) {
      return Launch{size, *processes, *number, true};
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<Launch> launch_from(const Environment& environment) {
  if (auto launch = by_mpirun(environment, "OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK")) {
    return launch;
  }
  if (auto launch = by_mpirun(environment, "PMI_SIZE", "PMI_RANK")) return launch;
  return by_srun(environment);
}

std::optional<std::string> fault_of_launch(const std::optional<Launch>& launch, unsigned ranks,
                                           bool serial) {
  if (!launch || launch->processes <= 1) return std::nullopt;
  if (serial) {
    if (launch->step_of_a_batch) return std::nullopt;
    return fmt::format(
        "--serial: kusabi was started by mpirun ({}={}), and each process would do the whole "
        "search; expected one process, or no --serial",
        launch->by, launch->processes);
  }
  if (ranks != 1) return std::nullopt;
  return fmt::format(
      "{}={}, but MPI does not connect this process with the others, and each would do the whole "
      "search; expected the mpirun of the MPI library that kusabi was built with{}",
      launch->by, launch->processes,
      launch->step_of_a_batch ? ", srun --mpi=pmix, or one task (srun -n 1, or --serial)" : "");
}

}  // namespace kusabi::run
