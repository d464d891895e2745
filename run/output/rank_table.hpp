// RankTable: statistics of each rank at the end of a search, as table and JSON. Columns of the
// engine are here; a subcommand adds those of its tree.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "engine/outcome.hpp"
#include "run/output/terminal_page.hpp"

namespace kusabi::run {

class RankTable {
 public:
  /// @param columns columns of the subcommand, between a rank's share and its messages
  explicit RankTable(std::vector<std::string> columns);

  /// Adds a rank of this run, in order of ranks. @param own one value per column
  void add(const engine::RankStatistics& statistics, const std::vector<std::uint64_t>& own);

  /// Adds a rank of an earlier run that this one resumes.
  void add_earlier(const engine::RankStatistics& statistics, const std::vector<std::uint64_t>& own);

  /// Adds the ranks of a search and of the runs that it resumes. @param own values of a tally
  template <class Outcome, class Own>
  void add_all(const Outcome& outcome, Own own) {
    for (const auto& rank : outcome.ranks) add(rank.statistics, own(rank.tally));
    for (const auto& rank : outcome.earlier) add_earlier(rank.statistics, own(rank.tally));
  }

  /// One line per rank and their sum; with more than 16 ranks the minimum, mean and maximum of each
  /// column over the ranks of this run instead. Shares are relative to all opened nodes, idle time
  /// is in percent of the run time, and seconds in the sum are those of this run.
  /// @param width columns that do not fit are printed below, with the rank column repeated
  [[nodiscard]] std::string text(std::size_t width = Page::endless) const;

 private:
  // Values of one rank in the order of the columns. Averages may be fractions.
  using Row = std::vector<double>;

  [[nodiscard]] Row row(const engine::RankStatistics& statistics,
                        const std::vector<std::uint64_t>& own) const;
  [[nodiscard]] Row sum() const;

  std::vector<std::string> columns_;
  std::vector<Row> ranks_;
  std::vector<Row> earlier_;
};

/// Adds the engine's statistics of one rank to an object of the result file.
void add_statistics(nlohmann::ordered_json& rank, const engine::RankStatistics& statistics);

/// For each rank in order: the values that `own` computes from its tally, and its statistics.
template <class Reports, class Own>
nlohmann::ordered_json rank_reports(const Reports& reports, Own own) {
  auto list = nlohmann::ordered_json::array();
  for (const auto& [statistics, tally] : reports) {
    nlohmann::ordered_json rank = own(tally);
    add_statistics(rank, statistics);
    list.push_back(std::move(rank));
  }
  return list;
}

}  // namespace kusabi::run
