// `kusabi patterns FILE --mu MU`: all sign patterns of wedged configurations (Algorithms 5.1, 5.8
// of the wedged paper): options, table, JSON and CSV.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "answer/verdict.hpp"
#include "engine/options.hpp"
#include "nodes/wedged/hold/firmness.hpp"
#include "nodes/wedged/pattern_search.hpp"
#include "nodes/wedged/sweep/pattern_brackets.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/command/option_table.hpp"
#include "run/command/problem_input.hpp"
#include "run/output/json_writer.hpp"
#include "run/output/terminal_page.hpp"
#include "run/wedged/configuration_files.hpp"
#include "run/wedged/contact_words.hpp"

namespace kusabi::run {

/// Order of the table. A pattern keeps its number, which result files and pictures use.
enum class PatternSort {
  number,    ///< order of the tree
  margin,    ///< largest margin first
  contact,   ///< fewest candidates in contact first
  critical,  ///< smallest critical friction coefficient first
};

struct PatternsOptions {
  ProblemInput input;
  double friction = 0;  ///< friction coefficient mu
  /// Of the search; complete after Subcommand::prepare().
  wedged::PatternParameters parameters;
  bool polyhedral = false;       ///< Algorithm 5.8; otherwise Algorithm 5.1
  int facets = 16;               ///< facets of the polyhedral friction cones of Algorithm 5.8
  bool list_candidates = false;  ///< lists the candidates of Algorithm 5.8 in the table
  PatternSort sort = PatternSort::number;
  /// Maximum number of candidates in which patterns of a group differ; 0: no groups; negative:
  /// groups on a terminal if the table would be long.
  int group = -1;
  std::uint64_t top = std::numeric_limits<std::uint64_t>::max();  ///< maximum number of rows
  engine::Limits limits;                                          ///< limits of the search
  CheckpointChoice checkpoint;                                    ///< files of its state
  std::string certificate;                                        ///< certificate file; empty: none
  bool whole = false;  ///< whole state of every pattern in the result file
  bool lines = false;  ///< result file with one line per pattern
  std::string trace;   ///< timeline file; empty: none
  std::string record;  ///< file of the nodes, for bench scaling; empty: none
  std::string vtu;     ///< folder of pictures; empty: none
};

/// Further numbers of each pattern, in the order of the findings; empty: not computed.
struct PatternNumbers {
  std::vector<wedged::PatternBracket> brackets;
  std::vector<std::optional<wedged::Firmness>> firmness;
};

/// All views of the findings.
class PatternsReport {
 public:
  /// All references must outlive it.
  /// @param in_lines numbers of the patterns of largest margin in a file of lines, or null
  PatternsReport(const PatternsOptions& options, const problems::WedgedProblem& problem,
                 const wedged::PatternFindings& findings, const PatternNumbers& numbers,
                 const Page& page, const std::vector<std::size_t>* in_lines = nullptr)
      : options_(options),
        problem_(problem),
        findings_(findings),
        brackets_(numbers.brackets),
        firmness_(numbers.firmness),
        page_(page),
        numbers_(in_lines) {}

  [[nodiscard]] answer::Verdict verdict() const;

  /// Patterns, rank statistics and times as text.
  [[nodiscard]] std::string table() const;

  /// The result file; its schema is in docs/result-files.md. One pattern at a time is in memory.
  /// @param head its first members @param whole of the same structure
  void write(JsonWriter& json, nlohmann::ordered_json head, const WholeStateJson& whole) const;

  /// First line of a result file with one line per pattern. @param head its first members
  [[nodiscard]] std::string head_line(nlohmann::ordered_json head) const;

  /// One row per pattern, in the order of the result file.
  void write_csv(std::ostream& out) const;

 private:
  /// Order of the leaves in the table.
  [[nodiscard]] std::vector<std::size_t> order() const;
  /// The table: one line per pattern, or per group of patterns.
  [[nodiscard]] std::string list() const;
  [[nodiscard]] std::string groups() const;
  /// True if a terminal shows an overview instead of a long list.
  [[nodiscard]] bool is_overview() const;
  [[nodiscard]] std::string overview() const;
  [[nodiscard]] std::string row(std::size_t number) const;
  [[nodiscard]] std::string names(const support::IndexSet& candidates) const;
  /// Pattern with the largest margin; past the end if there is none.
  [[nodiscard]] std::vector<wedged::Configuration>::const_iterator best() const {
    return std::ranges::max_element(findings_.leaves, {}, &wedged::Configuration::lower);
  }
  [[nodiscard]] std::string largest_margin() const;
  [[nodiscard]] std::string needed_friction(const wedged::Configuration& configuration,
                                            const FrictionNeed& need) const;
  /// Index of the bracket that begins lowest. @pre there are brackets
  [[nodiscard]] std::size_t first_to_stick() const;
  [[nodiscard]] std::string least_friction() const;
  [[nodiscard]] std::string largest_load() const;
  /// Sentences below the headline.
  [[nodiscard]] std::string details() const;
  [[nodiscard]] nlohmann::ordered_json result_json() const;
  [[nodiscard]] nlohmann::ordered_json statistics_json() const;
  /// Rows of the patterns with the largest margins, if the list is in a file of lines.
  [[nodiscard]] std::string largest() const;
  void write_patterns(JsonWriter& json, const WholeStateJson& whole) const;
  [[nodiscard]] nlohmann::ordered_json groups_json() const;
  [[nodiscard]] std::string candidates() const;
  [[nodiscard]] nlohmann::ordered_json candidates_json() const;

  const PatternsOptions& options_;
  const problems::WedgedProblem& problem_;
  const wedged::PatternFindings& findings_;
  const std::vector<wedged::PatternBracket>& brackets_;
  const std::vector<std::optional<wedged::Firmness>>& firmness_;
  Page page_;
  const std::vector<std::size_t>* numbers_;
};

/// Name in the table and the result file.
const char* state_name(wedged::LeafState state);

/// Words of --branching.
const OptionWords<wedged::Branching>& branching_words();

}  // namespace kusabi::run
