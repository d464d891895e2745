// What `kusabi patterns` says: the table for a person and the JSON for a program.
#pragma once

#include <cstddef>
#include <ostream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "nodes/wedged/pattern_search.hpp"
#include "nodes/wedged/sweep/pattern_brackets.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/output/page.hpp"
#include "run/patterns/patterns.hpp"
#include "run/verdict/verdict.hpp"
#include "run/wedged/whole_state_json.hpp"

namespace kusabi::run {

/// Everything that the command has to tell.
class PatternsReport {
 public:
  /// All references must outlive it. @param brackets one a leaf, or none
  PatternsReport(const PatternsOptions& options, const problems::WedgedProblem& problem,
                 const wedged::PatternFindings& findings,
                 const std::vector<wedged::PatternBracket>& brackets, const Page& page)
      : options_(options),
        problem_(problem),
        findings_(findings),
        brackets_(brackets),
        page_(page) {}

  [[nodiscard]] Verdict verdict() const;

  /// The patterns, the ranks' shares and the times, as text.
  [[nodiscard]] std::string table() const;

  /// The result file; its schema is in docs/result-files.md. @param whole of the same structure
  [[nodiscard]] nlohmann::ordered_json json(const WholeStateJson& whole) const;

  /// A row a pattern, in the order of the result file.
  void write_csv(std::ostream& out) const;

 private:
  /// The leaves as they are listed.
  [[nodiscard]] std::vector<std::size_t> order() const;
  /// The table: a line a pattern, or a line a group of them.
  [[nodiscard]] std::string list() const;
  [[nodiscard]] std::string groups() const;
  /// What a terminal shows of a long list.
  [[nodiscard]] bool is_overview() const;
  [[nodiscard]] std::string overview() const;
  [[nodiscard]] std::string row(std::size_t number) const;
  [[nodiscard]] std::string names(const support::IndexSet& candidates) const;
  [[nodiscard]] std::string firmest() const;
  /// What the sentence rests on.
  [[nodiscard]] std::string details() const;
  [[nodiscard]] nlohmann::ordered_json patterns_json(const WholeStateJson& whole) const;
  [[nodiscard]] nlohmann::ordered_json groups_json() const;
  [[nodiscard]] std::string candidates() const;
  [[nodiscard]] nlohmann::ordered_json candidates_json() const;

  const PatternsOptions& options_;
  const problems::WedgedProblem& problem_;
  const wedged::PatternFindings& findings_;
  const std::vector<wedged::PatternBracket>& brackets_;
  Page page_;
};

/// As the table and the result file call it.
const char* state_name(wedged::LeafState state);

}  // namespace kusabi::run
