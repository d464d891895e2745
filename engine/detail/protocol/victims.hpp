// Victims: choice of the rank that an idle rank requests work from, and the back-off.
#pragma once

#include <cstdint>
#include <vector>

namespace kusabi::engine {

/// The rank that gave last, as long as it gives; after its refusal, a random rank of its machine,
/// and after a refusal of that one, random neighbours in a fixed graph. A rank thus exchanges
/// messages with a bounded number of ranks of other machines, since MPI keeps memory for each.
/// After a refusal the pause before the next request doubles, to limit the load on busy ranks.
///
/// The graph joins rank r with the ranks r ± d, for the same random distances d on all ranks: about
/// 32 neighbours, or all others if there are no more.
class Victims {
 public:
  /// @param seed the same on all ranks
  /// @param machine the other ranks on the machine of this rank; empty if unknown
  /// @pre ranks >= 2
  Victims(int self, int ranks, std::uint64_t seed, std::vector<int> machine = {});

  /// Rank of the next request.
  [[nodiscard]] int choose();

  /// Neighbours in the graph, in increasing order.
  [[nodiscard]] const std::vector<int>& neighbours() const { return neighbours_; }

  /// True if the next request is due. @param now in seconds
  [[nodiscard]] bool due(double now) const { return now >= next_request_; }
  [[nodiscard]] double next_request() const { return next_request_; }

  /// True after several successive refusals.
  [[nodiscard]] bool refused_often() const { return refusals_ >= max_refusals_; }
  /// As after such refusals: for ranks that begin without nodes.
  void give_up() { refusals_ = max_refusals_; }

  /// True if a rank that still has nodes has asked often enough ahead of time.
  [[nodiscard]] bool has_requested_early() const { return refusals_ >= early_requests; }

  void sent(int victim);
  void refused(int victim, double now);

 private:
  // While most ranks have work, the first request succeeds; three successive refusals indicate that
  // few have. Few ranks ask their lifelines at once: any rank is at most three of them away.
  static constexpr unsigned max_refusals = 3;
  static constexpr int few_ranks = 8;
  static constexpr unsigned early_requests = 2;

  std::uint64_t random_;
  std::vector<int> machine_;
  std::vector<int> neighbours_;
  int last_sender_ = -1;
  unsigned max_refusals_;
  double pause_;
  double next_request_ = 0;
  // Since the last transfer:
  unsigned refusals_ = 0;
  bool drawn_refused_ = false;  // a rank drawn at random refused
};

}  // namespace kusabi::engine
