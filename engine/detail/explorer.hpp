// Explorer: the local search of one rank. It opens nodes, reports solutions and prunes by the
// incumbent. It sends no messages and never waits.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "engine/detail/cpu_clock.hpp"
#include "engine/detail/expanded.hpp"
#include "engine/detail/incumbent.hpp"
#include "engine/detail/nodes/frontier.hpp"
#include "engine/detail/nodes/heap.hpp"
#include "engine/detail/nodes/open_nodes.hpp"
#include "engine/detail/sense.hpp"
#include "engine/detail/solutions.hpp"
#include "engine/expansion.hpp"
#include "engine/options.hpp"
#include "engine/outcome.hpp"
#include "engine/problem.hpp"
#include "engine/wire.hpp"

namespace kusabi::engine {

template <class P>
class Explorer {
 public:
  using Node = StoredNode<P>;
  using Solution = typename P::Solution;

  /// Local state read from a checkpoint. When a search resumes on fewer ranks, a rank gets the
  /// open nodes of several: one bundle each, since each has its own trail.
  struct State {
    std::vector<Bundle<Node>> bundles;
    std::vector<FoundSolution<P>> found;
    Incumbent incumbent;
    double closed = 0;

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& bundles& found& incumbent& closed;
    }
  };

  /// State that is written as `State`, without a copy. The explorer must not change meanwhile.
  class SavedState {
   public:
    explicit SavedState(const Explorer& explorer) : explorer_(explorer) {}

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive << explorer_.bundles() << explorer_.solutions_.list()
              << explorer_.solutions_.incumbent() << explorer_.closed_;
    }

   private:
    const Explorer& explorer_;
  };

  /// @param serve called by a long expansion that polls
  /// @throws std::invalid_argument if the options require functions that the problem lacks
  Explorer(P& problem, const Options& options, std::function<bool()> serve)
      : problem_(problem),
        goal_(options.goal),
        order_(options.order),
        check_share_(options.check_expand),
        record_(options.record),
        watched_(check_share_ > 0 || record_),
        heap_(options.heap_nodes, options.heap_bytes),
        solutions_(problem, options),
        expansion_(
            frontier_, solutions_.incumbent(),
            [this](Solution&& solution) { report(std::move(solution)); }, std::move(serve)) {
    if (goal_ == Goal::best && !Optimising<P>) {
      throw std::invalid_argument("Goal::best requires a problem with an objective()");
    }
    if (record_ && order_ != Order::depth_first) {
      throw std::invalid_argument("Options::record requires depth-first order");
    }
    if (order_ != Order::depth_first && !Bounded<P>) {
      throw std::invalid_argument("orders other than depth first require a problem with a bound()");
    }
  }

  Explorer(const Explorer&) = delete;
  Explorer& operator=(const Explorer&) = delete;

  void add_root() { frontier_.add_root(stored<P>(std::as_const(problem_).root())); }

  // ---- opening nodes ----------------------------------------------------------------------------

  [[nodiscard]] bool has_nodes() const {
    return !frontier_.empty() || !waiting_.empty() || !heap_.empty();
  }

  /// True while a node is expanded twice; the incumbent and the open nodes must not change then.
  [[nodiscard]] bool checking() const { return expanded_ != nullptr; }

  /// True during a call of `expand`.
  [[nodiscard]] bool expanding() const { return expanding_; }

  /// True if a node is being expanded or is open.
  [[nodiscard]] bool busy() const { return expanding_ || has_nodes(); }

  /// Number of open nodes.
  [[nodiscard]] std::uint64_t open() const {
    return frontier_.size() + heap_.size() + waiting_nodes_;
  }

  /// Opens at most `count` nodes.
  /// @throws ExpansionFailed if the problem's `expand` throws
  void open_nodes(unsigned count) {
    for (; count > 0; --count) {
      if (frontier_.empty() && !next_nodes()) return;
      if (!open_node()) return;
      if (order_ != Order::depth_first) move_to_heap();
    }
  }

  /// Least bound of the open nodes; infinity if there are none.
  [[nodiscard]] double bound() const {
    if (!has_nodes()) return std::numeric_limits<double>::infinity();
    if (!prunes_by_bound()) return bound_of_any();
    double minimum = std::numeric_limits<double>::infinity();
    if (!heap_.empty()) minimum = bound_of(heap_.best());
    frontier_.for_each([&](const Node& node) { minimum = std::min(minimum, bound_of(node)); });
    for (const auto& bundle : waiting_) {
      for (const auto& open : bundle.nodes) minimum = std::min(minimum, bound_of(open.node));
    }
    return minimum;
  }

  // ---- giving and taking ------------------------------------------------------------------------

  [[nodiscard]] bool can_transfer() const {
    return heap_.can_transfer() || frontier_.can_transfer() || stores() >= 2;
  }

  /// Half of the nodes for another rank, but not more than about `maximum` pieces of about `limit`
  /// bytes (in_pieces) or `maximum` bundles. A heap gives one piece, since its best nodes count,
  /// not their number.
  std::vector<Transfer<Node>> give(std::size_t limit, std::size_t maximum) {
    std::vector<Transfer<Node>> transfers;
    const auto add = [&](Bundle<Node>&& bundle) {
      for (auto& piece : in_pieces(std::move(bundle), limit)) {
        transfers.emplace_back().push_back(std::move(piece));
      }
    };
    if (heap_.can_transfer()) {
      transfers.push_back(heap_.give(limit));
    } else if (waiting_.size() >= 2) {
      for (auto& bundle : give_waiting(maximum)) add(std::move(bundle));
    } else if (frontier_.can_transfer()) {
      add(frontier_.give(limit * maximum));
    } else if (!heap_.empty()) {
      add(heap_.take());
    } else {
      auto& bundle = waiting_.back();
      waiting_nodes_ -= bundle.nodes.size();
      add({bundle.trail, bundle.nodes.give((bundle.nodes.size() + 1) / 2, limit * maximum)});
      waiting_nodes_ += bundle.nodes.size();
      if (bundle.nodes.empty()) waiting_.pop_back();
    }
    return transfers;
  }

  void take(Transfer<Node>&& transfer) {
    for (auto& bundle : transfer) keep(std::move(bundle));
  }

  // ---- results ----------------------------------------------------------------------------------

  void report(Solution&& solution) {
    if (expanded_ != nullptr) expanded_->solutions.push_back(pack(solution));
    if (solutions_.report(std::move(solution), frontier_.path(), bound_)) ++statistics_.found;
  }

  [[nodiscard]] Solutions<P>& solutions() { return solutions_; }
  [[nodiscard]] const Solutions<P>& solutions() const { return solutions_; }
  [[nodiscard]] Goal goal() const { return goal_; }
  /// True if the problem takes its solutions itself.
  [[nodiscard]] bool emits() const { return Emitting<P> && goal_ == Goal::all; }
  [[nodiscard]] double closed() const { return closed_; }

  /// Statistics of this rank: nodes opened, mark sum, solutions found, nodes pruned, peak number of
  /// open nodes.
  [[nodiscard]] const RankStatistics& statistics() const { return statistics_; }
  [[nodiscard]] RankStatistics& statistics() {
    statistics_.peak_open = std::max<std::uint64_t>(statistics_.peak_open, frontier_.peak());
    return statistics_;
  }

  // ---- state ------------------------------------------------------------------------------------

  /// @pre no node is being expanded
  [[nodiscard]] SavedState state() const { return SavedState(*this); }

  void restore(State&& state) {
    take(std::move(state.bundles));
    solutions_.add(std::move(state.found), state.incumbent);
    closed_ += state.closed;
  }

 private:
  // A bundle of open nodes, as a stack.
  struct Waiting {
    std::vector<TrailStep> trail;
    NodeStack<Node> nodes;
  };

  // All open nodes, deepest last.
  [[nodiscard]] SavedList<SavedBundle<Node>> bundles() const {
    auto in_heap = heap_.all();
    const auto count = in_heap.size + waiting_.size() + (frontier_.empty() ? 0 : 1);
    return {count, [this, in_heap = std::move(in_heap)](const auto& look) {
              in_heap.for_each(look);
              for (const auto& bundle : waiting_) look({bundle.trail, bundle.nodes.all()});
              if (!frontier_.empty()) look(frontier_.all());
            }};
  }

  // Bound by which a node is pruned.
  [[nodiscard]] double bound_of(const Node& node) const {
    return prunes_by_bound() ? sort_key(node) : bound_of_any();
  }

  [[nodiscard]] bool prunes_by_bound() const { return Bounded<P> && goal_ == Goal::best; }

  // Least bound of open nodes that were not pruned by bound.
  [[nodiscard]] double bound_of_any() const {
    return goal_ == Goal::first ? 0 : -std::numeric_limits<double>::infinity();
  }

  // Sort key of a node in the heap: its bound, even if the goal does not prune by it.
  [[nodiscard]] double sort_key(const Node& node) const {
    if constexpr (Bounded<P>) {
      if (std::isnan(node.bound)) {
        node.bound = oriented<P>(std::as_const(problem_).bound(node.node));
      }
      return node.bound;
    }
    return 0;
  }

  // Number of containers that hold nodes: the frontier, the waiting bundles and the heap. Each
  // could be given to another rank as a whole, except the one that is being expanded.
  [[nodiscard]] std::size_t stores() const {
    const bool own = expanding_ || !frontier_.empty();
    return (own ? 1 : 0) + waiting_.size() + (heap_.empty() ? 0 : 1);
  }

  void keep(Bundle<Node>&& bundle) {
    if (order_ == Order::depth_first) {
      waiting_nodes_ += bundle.nodes.size();
      waiting_.push_back({std::move(bundle.trail), NodeStack<Node>(std::move(bundle.nodes))});
    } else {
      heap_.put(std::move(bundle), [this](const Node& node) { return sort_key(node); });
    }
  }

  // Removes and returns every other bundle that follows the frontier, at most `maximum`.
  std::vector<Bundle<Node>> give_waiting(std::size_t maximum) {
    std::vector<Bundle<Node>> given;
    const auto begin = waiting_.begin();
    const auto end = begin + static_cast<std::ptrdiff_t>(std::min(2 * maximum, waiting_.size()));
    auto kept = begin;
    for (auto bundle = begin; bundle != end; ++bundle) {
      if ((bundle - begin) % 2 == 0) {
        waiting_nodes_ -= bundle->nodes.size();
        given.push_back({std::move(bundle->trail), bundle->nodes.take_all()});
      } else {
        *kept++ = std::move(*bundle);
      }
    }
    waiting_.erase(kept, end);
    return given;
  }

  bool next_nodes() {
    if (!heap_.empty()) {
      frontier_.take(heap_.take());
      return true;
    }
    if (waiting_.empty()) return false;
    auto& next = waiting_.back();
    waiting_nodes_ -= next.nodes.size();
    frontier_.take({std::move(next.trail), next.nodes.take_all()});
    waiting_.pop_back();
    return true;
  }

  // Moves the children of the node just opened, and all other nodes of the frontier, into the heap,
  // unless the order continues below this node or the heap is full.
  void move_to_heap() {
    statistics_.peak_open = std::max(statistics_.peak_open, open());
    const bool goes_on = order_ == Order::hybrid && frontier_.branches() > 0;
    if (frontier_.empty() || goes_on || heap_.full()) return;
    keep(frontier_.take_all());
  }

  // @return true if it was opened, or pruned: not put back
  bool open_node() {
    Node node = frontier_.open();
    if (prunes_by_bound()) bound_ = sort_key(node);
    if (solutions_.incumbent().rules_out(bound_, frontier_.place())) {
      ++statistics_.pruned;
    } else {
      ++statistics_.opened;
      statistics_.fingerprint += frontier_.mark();
      if (watched_) [[unlikely]] {
        expand_watched(std::move(node));
      } else {
        expand(std::move(node));
      }
      if (expansion_.unopened()) [[unlikely]] {
        put_back();
        return false;
      }
    }
    closed_ += frontier_.close();
    return true;
  }

  void put_back() {
    --statistics_.opened;
    statistics_.fingerprint -= frontier_.mark();
    frontier_.put_back(stored<P>(std::move(*std::exchange(expansion_.unopened(), {}))));
  }

  // Expands a node for Options::check_expand and Options::record.
  void expand_watched(Node&& node) {
    const double begun = record_ ? cpu_seconds() : 0;
    is_checked(frontier_.mark()) ? expand_twice(std::move(node)) : expand(std::move(node));
    if (record_) record_(frontier_.depth(), cpu_seconds() - begun);
  }

  // A pseudo-random share of the nodes, the same for any number of ranks.
  [[nodiscard]] bool is_checked(std::uint64_t mark) const {
    constexpr double all_hashes = 0x1p64;
    return check_share_ > 0 && static_cast<double>(hash_of_mark(mark)) <= check_share_ * all_hashes;
  }

  // Expands a node twice with the same incumbent; the first result is only compared.
  void expand_twice(Node&& node) {
    const auto statistics = statistics_;
    solutions_.begin_trial_expansion();
    const auto first = expanded_of(Node(node));
    frontier_.take_back();
    solutions_.end_trial_expansion();
    statistics_ = statistics;
    const auto second = expanded_of(std::move(node));
    if (const auto what = difference(first, second)) {
      throw ExpansionDiffers(frontier_.path(), *what);
    }
  }

  Expanded expanded_of(Node&& node) {
    Expanded expanded;
    expanded_ = &expanded;
    expand(std::move(node));
    expanded_ = nullptr;
    frontier_.for_each_child([&](const Node& child) {
      expanded.children.push_back({pack(node_of(child)), oriented<P>(sort_key(child))});
    });
    return expanded;
  }

  void expand(Node&& node) {
    expanding_ = true;
    try {
      problem_.expand(std::move(node_of(node)), expansion_);
    } catch (...) {
      rethrow_from_expand(frontier_.path());
    }
    expanding_ = false;
  }

  P& problem_;
  Goal goal_;
  Order order_;
  double check_share_;  // share of the nodes that are expanded twice
  const std::function<void(std::size_t, double)>& record_;
  bool watched_;                        // nodes are expanded twice or recorded
  Expanded* expanded_ = nullptr;        // of the node that is being expanded twice
  Frontier<Node, WorkOf<P>> frontier_;  // the part searched depth first
  // bundles that follow the frontier; used with depth-first order only
  std::deque<Waiting> waiting_;
  std::size_t waiting_nodes_ = 0;  // in these bundles
  Heap<Node> heap_;                // used with all other orders
  Solutions<P> solutions_;
  Expansion<P> expansion_;
  bool expanding_ = false;
  double bound_ = bound_of_any();  // of the node opened last
  double closed_ = 0;
  RankStatistics statistics_;
};

}  // namespace kusabi::engine
