// Program: the part of `run` that does not depend on the problem type: MPI, options of the command
// line, the state to resume from, progress, and the summary at the end.
#pragma once

#include <cstdint>
#include <fstream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/options.hpp"
#include "engine/statistics.hpp"
#include "engine/transport/mpi.hpp"
#include "engine/transport/transport.hpp"

namespace kusabi::engine {

/// Requests of the command line of a search program.
struct CommandLine {
  Options options;
  std::string resume;  ///< file of --resume; empty: none
  std::string record;  ///< file of --record; empty: none
  bool quiet = false;
  std::string help;                ///< text that --help requests; empty: not requested
  std::vector<std::string> words;  ///< all others, those of the program itself
};

/// Abilities of a problem type.
struct ProblemKind {
  bool has_objective = false;
  bool bounded = false;
};

/// @param argv at least the name of the program
/// @param options of the program; those of the command line take precedence
/// @throws std::invalid_argument with one line that names the option and what was expected
CommandLine read_command_line(int argc, const char* const* argv, ProblemKind kind,
                              const Options& options = {});

/// Words of the command line that are not options of `run`, for the problem.
std::vector<std::string> own_words(int argc, const char* const* argv);

class Program {
 public:
  /// Initialises MPI if a launcher started this process.
  Program(int& argc, char**& argv, ProblemKind kind, const Options& options);

  /// Present if there is nothing to search: after --help, or with a wrong option.
  [[nodiscard]] std::optional<int> exit_code() const { return exit_code_; }

  /// Finds the state of --resume, and catches signals from here on.
  /// @param type name of the problem type
  /// @param instance number of the instance, 0 if the words of the command line determine it
  /// @throws CheckpointError if the state is damaged or of another problem; over MPI one line is
  ///   printed and all ranks end
  void prepare(const std::string& type, std::uint64_t instance);

  [[nodiscard]] Transport& transport() { return *transport_; }
  [[nodiscard]] const Options& options() const { return line_.options; }
  [[nodiscard]] bool is_first() const { return transport_->rank() == 0; }

  struct End {
    Status status = Status::solved;
    std::uint64_t opened = 0;
    std::uint64_t open = 0;
    bool saved = false;
  };

  /// Prints the summary on rank 0, and removes the state of a finished search.
  /// @return the exit code, the same on all ranks
  int finish(const End& end);

 private:
  void show(const Progress& progress);
  void record_tree();
  [[nodiscard]] double seconds() const;

  std::optional<MpiEnvironment> mpi_;
  std::unique_ptr<Transport> transport_;
  CommandLine line_;
  std::ofstream recording_;
  std::optional<int> exit_code_;
  double begun_ = 0;
  double shown_ = 0;
};

}  // namespace kusabi::engine
