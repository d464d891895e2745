// PairedTurns: the CPU time that two programs take for the same work, from short turns of each.
//
// CPU times of two whole runs, one after the other, compare the load of the machine at two moments:
// caches, clock rates and memory are shared with other programs. Two turns of some 50 ms one after
// the other see the same load, and the median of many ratios ignores the turns in which it changed.
#pragma once

#include <cstdint>
#include <vector>

namespace kusabi::run {

/// CPU seconds of a turn and the nodes opened in it, or of several turns.
struct Turn {
  double seconds = 0;
  std::uint64_t nodes = 0;

  Turn& operator+=(const Turn& other) {
    seconds += other.seconds;
    nodes += other.nodes;
    return *this;
  }
};

/// Turns of a recursion and of a search. A pair consists of consecutive turns of both with at least
/// a certain CPU time each, as a loaded machine gives a turn little time.
class PairedTurns {
 public:
  /// @param least CPU seconds of each half of a pair
  explicit PairedTurns(double least) : least_(least) {}

  void add_recursion(const Turn& turn) { recursion_ += turn; }
  void add_search(const Turn& turn);

  /// CPU seconds of the search in all its turns.
  [[nodiscard]] double search_seconds() const { return search_seconds_; }

  /// For each pair, the CPU time of a node in the recursion divided by that in the search; 0 if the
  /// search had no node. If no pair is complete, that of all turns; empty if one of both had none.
  [[nodiscard]] std::vector<double> ratios() const;

 private:
  // The ratio of the turns that are in no pair yet.
  [[nodiscard]] double open_ratio() const;

  double least_;
  Turn recursion_;  // of the turns that are in no pair yet
  Turn search_;
  double search_seconds_ = 0;
  std::vector<double> ratios_;
};

/// Quartiles of some values, by linear interpolation between the sorted ones.
struct Quartiles {
  double lower = 0;
  double median = 0;
  double upper = 0;
};

/// @pre there is a value
Quartiles quartiles(std::vector<double> values);

}  // namespace kusabi::run
