// PatternLines: the list of `kusabi patterns --format jsonl`, one line per pattern. Each rank
// writes its feasible patterns during the search to a part of its own; at the end rank 0 sorts the
// lines of all parts into the file. Memory does not grow with the list, and the file does not
// depend on the number of ranks.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "nodes/wedged/hold/firmness.hpp"
#include "nodes/wedged/pattern_search.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/evidence/part_files.hpp"
#include "run/session/session.hpp"

namespace kusabi::run {

/// A pattern as in the list of a result file, without its friction coefficient and displacements.
/// @param inactive candidates of blocks that cannot wedge
nlohmann::ordered_json lean_pattern(const problems::WedgedProblem& problem,
                                    const wedged::Configuration& leaf,
                                    const support::IndexSet& inactive = {});

/// The key `firmness` of a pattern.
nlohmann::ordered_json firmness_json(const std::optional<wedged::Firmness>& firmness);

class PatternLines {
 public:
  /// Opens a part on every rank, unless an earlier run has finished.
  /// @param goes_on as PartFiles()
  /// @param firmness of each pattern; null if the file has no reference load. Must outlive it
  PatternLines(Session& session, const problems::WedgedProblem& problem, const PartsOwner& owner,
               const wedged::PatternFirmness* firmness, bool goes_on, bool finished);

  /// Writes a feasible pattern to the part of this rank.
  void add(const wedged::Configuration& leaf);

  /// Closes the parts, and removes flat patterns of the findings that are contained in a recorded
  /// one. Collective over all ranks.
  void close(wedged::PatternFindings& findings);

  /// Writes the head line and all patterns in the order of a result file. On rank 0.
  /// @param head without patterns
  /// @return false if the file of an earlier run has this head: it stays as it is
  /// @throws std::runtime_error if a part is missing or incomplete
  bool write(std::ostream& out, const std::string& head, const wedged::PatternFindings& findings);

  /// Number in the list, from 1, of each of the patterns of largest margin; 0 before write().
  [[nodiscard]] const std::vector<std::size_t>& numbers() const { return numbers_; }

  /// Checks the parts for a run that resumes, or removes them. On rank 0, after write().
  void end(bool goes_on);

 private:
  [[nodiscard]] std::string line_of(const wedged::Configuration& leaf,
                                    const support::IndexSet& inactive = {}) const;
  void keep_flat_of_earlier(wedged::PatternFindings& findings) const;
  void count_earlier(const std::string& head, const std::vector<std::string>& largest);
  // Sets the number of a pattern of largest margin, if the line is that of one.
  void note_number(const std::vector<std::string>& largest, const std::string& line,
                   std::size_t number);

  const problems::WedgedProblem& problem_;
  PartsOwner owner_;
  const wedged::PatternFirmness* firmness_;
  std::optional<PartFiles> parts_;
  std::vector<std::size_t> numbers_;
};

}  // namespace kusabi::run
