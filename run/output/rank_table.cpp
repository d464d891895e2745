// All columns are numbers until they are printed, so sums and means are one loop.
#include "run/output/rank_table.hpp"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <string_view>
#include <utility>

#include <fmt/format.h>

namespace kusabi::run {
namespace {

constexpr std::size_t max_lines = 16;

// Columns of the engine: two before those of the subcommand, the others after them. Shares and idle
// times are kept as nodes and seconds, which can be added, and divided when printed.
constexpr std::size_t opened_column = 0;
constexpr std::size_t share_column = 1;
constexpr std::string_view after_own[] = {"requests", "transfers", "messages", "idle", "seconds"};

// The first column, and as many others as fit; further columns below, with the first repeated.
std::string side_by_side(const std::vector<std::vector<std::string>>& lines, std::size_t width) {
  std::vector<std::size_t> widths(lines.front().size(), 0);
  for (const auto& line : lines) {
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
  }
  std::string text;
  auto out = std::back_inserter(text);
  for (std::size_t first = 1; first < widths.size();) {
    std::size_t end = first;
    for (auto used = widths.front(); end < widths.size(); ++end) {
      used += widths[end] + 2;
      if (used > width && end > first) break;
    }
    if (first > 1) text += '\n';
    for (const auto& line : lines) {
      fmt::format_to(out, "{:<{}}", line.front(), widths.front());
      for (std::size_t i = first; i < end; ++i) fmt::format_to(out, "  {:>{}}", line[i], widths[i]);
      text += '\n';
    }
    first = end;
  }
  return text;
}

double ratio(double part, double whole) {
  return whole > 0 ? part / whole : 0;
}

}  // namespace

RankTable::RankTable(std::vector<std::string> columns) : columns_{"opened", "share"} {
  std::move(columns.begin(), columns.end(), std::back_inserter(columns_));
  columns_.insert(columns_.end(), std::begin(after_own), std::end(after_own));
}

RankTable::Row RankTable::row(const engine::RankStatistics& statistics,
                              const std::vector<std::uint64_t>& own) const {
  const auto opened = static_cast<double>(statistics.opened);
  Row row{opened, opened};
  for (const auto value : own) row.push_back(static_cast<double>(value));
  row.push_back(static_cast<double>(statistics.requests));
  row.push_back(static_cast<double>(statistics.transfers_received));
  row.push_back(static_cast<double>(statistics.messages_sent));
  row.push_back(statistics.idle_seconds);
  row.push_back(statistics.seconds);
  assert(row.size() == columns_.size());
  return row;
}

void RankTable::add(const engine::RankStatistics& statistics,
                    const std::vector<std::uint64_t>& own) {
  ranks_.push_back(row(statistics, own));
}

void RankTable::add_earlier(const engine::RankStatistics& statistics,
                            const std::vector<std::uint64_t>& own) {
  earlier_.push_back(row(statistics, own));
}

RankTable::Row RankTable::sum() const {
  Row total(columns_.size(), 0.0);
  for (const auto* rows : {&ranks_, &earlier_}) {
    for (const auto& each : *rows) {
      for (std::size_t column = 0; column < total.size(); ++column) total[column] += each[column];
    }
  }
  return total;
}

std::string RankTable::text(std::size_t width) const {
  const std::size_t seconds_column = columns_.size() - 1;
  const std::size_t idle_column = columns_.size() - 2;
  const Row total = sum();

  std::vector<std::vector<std::string>> lines{{"rank"}};
  std::copy(columns_.begin(), columns_.end(), std::back_inserter(lines.front()));
  // Idle time is relative to `seconds` of rank time, not to the last column.
  const auto add_line = [&](const std::string& name, const Row& row, double rank_seconds) {
    auto& cells = lines.emplace_back(1, name);
    for (std::size_t column = 0; column < row.size(); ++column) {
      if (column == share_column) {
        cells.push_back(fmt::format("{:.1f} %", 100 * ratio(row[column], total[opened_column])));
      } else if (column == idle_column) {
        cells.push_back(fmt::format("{:.1f} %", 100 * ratio(row[column], rank_seconds)));
      } else {
        cells.push_back(fmt::format("{:.{}f}", row[column], column == seconds_column ? 3 : 0));
      }
    }
  };
  const auto add_rank = [&](const std::string& name, const Row& row) {
    add_line(name, row, row[seconds_column]);
  };

  double longest = 0;
  for (const auto& each : ranks_) longest = std::max(longest, each[seconds_column]);
  if (ranks_.size() <= max_lines) {
    for (std::size_t rank = 0; rank < ranks_.size(); ++rank) {
      add_rank(std::to_string(rank), ranks_[rank]);
    }
  } else {
    Row minimum = ranks_.front();
    Row mean(columns_.size(), 0.0);
    Row maximum = ranks_.front();
    for (const auto& each : ranks_) {
      for (std::size_t column = 0; column < each.size(); ++column) {
        minimum[column] = std::min(minimum[column], each[column]);
        mean[column] += each[column] / static_cast<double>(ranks_.size());
        maximum[column] = std::max(maximum[column], each[column]);
      }
    }
    add_line("least", minimum, longest);
    add_line("mean", mean, longest);
    add_line("most", maximum, longest);
  }
  if (ranks_.size() + earlier_.size() <= max_lines) {
    for (const auto& each : earlier_) add_rank("before", each);
  }
  if (ranks_.size() + earlier_.size() > 1) {
    Row all = total;
    all[seconds_column] = longest;
    add_line("all", all, total[seconds_column]);
  }

  return side_by_side(lines, width);
}

void add_statistics(nlohmann::ordered_json& rank, const engine::RankStatistics& statistics) {
  rank["opened"] = statistics.opened;
  rank["peak_open"] = statistics.peak_open;
  rank["requests"] = statistics.requests;
  rank["transfers_received"] = statistics.transfers_received;
  rank["transfers_sent"] = statistics.transfers_sent;
  rank["nodes_sent"] = statistics.nodes_given;
  rank["messages_sent"] = statistics.messages_sent;
  rank["idle_seconds"] = statistics.idle_seconds;
  rank["seconds"] = statistics.seconds;
}

}  // namespace kusabi::run
