// The summary at the end of a search: what each rank did, as a table and as JSON. The columns of
// the engine are here; a subcommand adds those of its own tree.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "engine/outcome.hpp"
#include "run/output/page.hpp"

namespace kusabi::run {

class RankTable {
 public:
  /// @param columns the subcommand's own, between a rank's share and its messages
  explicit RankTable(std::vector<std::string> columns);

  /// One rank of this run, in their order. @param own as many values as columns
  void add(const engine::RankStatistics& statistics, const std::vector<std::uint64_t>& own);

  /// One rank of an earlier run that this one went on from.
  void add_earlier(const engine::RankStatistics& statistics, const std::vector<std::uint64_t>& own);

  /// A line a rank and their sum; with more than 16 ranks the least, the mean and the greatest of
  /// each column instead, over the ranks of this run. Shares are of all nodes opened, idle time is
  /// in percent of the time of the run, and the sum's seconds are those of this run.
  /// @param width columns that do not fit go below, with the ranks in front of them again
  [[nodiscard]] std::string text(std::size_t width = Page::endless) const;

 private:
  // One rank's values in the order of the columns. Averages need not be whole.
  using Row = std::vector<double>;

  [[nodiscard]] Row row(const engine::RankStatistics& statistics,
                        const std::vector<std::uint64_t>& own) const;
  [[nodiscard]] Row sum() const;

  std::vector<std::string> columns_;
  std::vector<Row> ranks_;
  std::vector<Row> earlier_;
};

/// The engine's statistics of one rank, added to an object of the result file.
void add_statistics(nlohmann::ordered_json& rank, const engine::RankStatistics& statistics);

/// Of each rank of a run, in their order: what `own` makes of its tally, and its statistics.
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
