// The part of a rank that searches: it opens the nodes it has, collects what they yield, and prunes
// what cannot be better than the best known. It sends nothing and waits for nothing.
#pragma once

#include <algorithm>
#include <cmath>
#include <exception>
#include <functional>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "engine/expansion.hpp"
#include "engine/frontier.hpp"
#include "engine/incumbent.hpp"
#include "engine/options.hpp"
#include "engine/outcome.hpp"
#include "engine/problem.hpp"

namespace kusabi::engine {

/// An exception that left `expand`, with the path of the node it was expanding; the exception
/// itself is nested in it.
class ExpansionFailed : public std::runtime_error {
 public:
  ExpansionFailed(const Path& path, const std::string& reason)
      : std::runtime_error("node " + to_string(path) + ": " + reason) {}
};

template <class P>
class Explorer {
 public:
  using Node = typename P::Node;
  using Solution = typename P::Solution;

  /// All that a rank must keep to go on later. Frontiers of several ranks may meet on one when a
  /// search goes on with fewer: each is a bundle of its own, since each has its own trail.
  struct State {
    std::vector<Gift<Node>> bundles;
    std::vector<Found<P>> found;
    Incumbent incumbent;
    double closed = 0;

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& bundles& found& incumbent& closed;
    }
  };

  /// @param serve called by a long expansion that polls
  Explorer(P& problem, Goal goal, std::function<void()> serve)
      : problem_(problem), goal_(goal), expansion_(*this, std::move(serve)) {}

  Explorer(const Explorer&) = delete;
  Explorer& operator=(const Explorer&) = delete;

  void plant() { frontier_.plant(std::as_const(problem_).root()); }

  // ---- opening nodes ----------------------------------------------------------------------------

  [[nodiscard]] bool has_nodes() const { return !frontier_.empty() || !bundles_.empty(); }

  /// Whether this is called from inside an expansion.
  [[nodiscard]] bool expanding() const { return expanding_; }

  /// Whether a node is being expanded or waits to be.
  [[nodiscard]] bool busy() const { return expanding_ || has_nodes(); }

  /// Nodes waiting to be opened.
  [[nodiscard]] std::uint64_t open() const {
    std::uint64_t count = frontier_.size();
    for (const auto& bundle : bundles_) count += bundle.nodes.size();
    return count;
  }

  /// Opens at most `count` nodes.
  /// @throws ExpansionFailed if the problem's `expand` throws
  void open_nodes(unsigned count) {
    for (; count > 0; --count) {
      if (frontier_.empty() && !next_bundle()) return;
      open_node();
    }
  }

  /// The least bound of the nodes that wait; infinity if there is none.
  [[nodiscard]] double bound() const {
    double least = std::numeric_limits<double>::infinity();
    frontier_.for_each([&](const Node& node) { least = std::min(least, bound_of(node)); });
    for (const auto& bundle : bundles_) {
      for (const auto& open : bundle.nodes) least = std::min(least, bound_of(open.node));
    }
    return least;
  }

  // ---- giving and taking ------------------------------------------------------------------------

  [[nodiscard]] bool can_give() const {
    const std::size_t others = expanding_ || !frontier_.empty() ? 1 : 0;
    return frontier_.can_give() || (!bundles_.empty() && bundles_.size() + others >= 2);
  }

  /// Nodes for another rank, of at most `limit` bytes together unless one alone has more.
  /// @pre can_give()
  Gift<Node> give(std::size_t limit) {
    if (frontier_.can_give()) return frontier_.give(limit);
    auto& bundle = bundles_.back();
    Gift<Node> gift{bundle.trail, take_every_other(bundle.nodes, bundle.nodes.size(), limit)};
    if (bundle.nodes.empty()) bundles_.pop_back();
    return gift;
  }

  void take(Gift<Node>&& gift) { bundles_.push_back(std::move(gift)); }

  // ---- results ----------------------------------------------------------------------------------

  void report(Solution&& solution) {
    if (goal_ == Goal::all) {
      found_.push_back({frontier_.path(), std::move(solution)});
      ++statistics_.found;
      return;
    }
    const Incumbent candidate{true, objective(solution), frontier_.path()};
    if (std::isnan(candidate.objective)) throw std::domain_error("the objective is not a number");
    if (!candidate.better_than(incumbent_)) return;
    incumbent_ = candidate;
    ++statistics_.found;
    found_.clear();
    found_.push_back({frontier_.path(), std::move(solution)});
    improved_ = true;
  }

  /// Takes note of a solution that another rank has. @return true if it is better than the best
  /// known here; the own one, if any, is then of no more use.
  bool learn(const Incumbent& news) {
    if (!news.better_than(incumbent_)) return false;
    incumbent_ = news;
    if (goal_ != Goal::all) found_.clear();
    return true;
  }

  [[nodiscard]] const Incumbent& incumbent() const { return incumbent_; }

  /// Whether the incumbent was improved here since the last call.
  [[nodiscard]] bool just_improved() { return std::exchange(improved_, false); }

  [[nodiscard]] std::vector<Found<P>>& found() { return found_; }
  [[nodiscard]] double closed() const { return closed_; }

  /// Nodes opened here, their fingerprint, solutions, nodes pruned, most open nodes.
  [[nodiscard]] RankStatistics& statistics() {
    statistics_.peak_open = frontier_.peak();
    return statistics_;
  }

  // ---- state ------------------------------------------------------------------------------------

  /// @pre no node is being expanded
  [[nodiscard]] State state() const {
    State state{bundles_, found_, incumbent_, closed_};
    if (!frontier_.empty()) state.bundles.push_back(frontier_.all());
    return state;
  }

  void restore(State&& state) {
    std::move(state.bundles.begin(), state.bundles.end(), std::back_inserter(bundles_));
    std::move(state.found.begin(), state.found.end(), std::back_inserter(found_));
    closed_ += state.closed;
    if (state.incumbent.better_than(incumbent_)) incumbent_ = state.incumbent;
  }

 private:
  friend class Expansion<P>;

  [[nodiscard]] double objective(const Solution& solution) const {
    if constexpr (Minimising<P>) {
      if (goal_ == Goal::best) return std::as_const(problem_).objective(solution);
    }
    return 0;  // Goal::first: all solutions alike, the smaller path is better
  }

  [[nodiscard]] double bound_of(const Node& node) const {
    if constexpr (Bounded<P>) {
      if (goal_ == Goal::best) return std::as_const(problem_).bound(node);
    }
    return goal_ == Goal::first ? 0 : -std::numeric_limits<double>::infinity();
  }

  bool next_bundle() {
    if (bundles_.empty()) return false;
    frontier_.take(std::move(bundles_.back()));
    bundles_.pop_back();
    return true;
  }

  void open_node() {
    Node node = frontier_.open();
    if (incumbent_.exists && incumbent_.rules_out(bound_of(node), frontier_.path())) {
      ++statistics_.pruned;
    } else {
      ++statistics_.opened;
      statistics_.fingerprint += frontier_.current().hash;
      expand(std::move(node));
    }
    if (frontier_.current().branches == 0) closed_ += frontier_.current().share;
    frontier_.close();
  }

  void expand(Node&& node) {
    expanding_ = true;
    try {
      problem_.expand(std::move(node), expansion_);
    } catch (const std::exception& error) {
      std::throw_with_nested(ExpansionFailed(frontier_.path(), error.what()));
    } catch (...) {
      std::throw_with_nested(ExpansionFailed(frontier_.path(), "an unknown exception"));
    }
    expanding_ = false;
  }

  P& problem_;
  Goal goal_;
  Frontier<Node> frontier_;
  std::vector<Gift<Node>> bundles_;
  Expansion<P> expansion_;
  bool expanding_ = false;
  bool improved_ = false;
  std::vector<Found<P>> found_;
  Incumbent incumbent_;
  double closed_ = 0;
  RankStatistics statistics_;
};

template <class P>
void Expansion<P>::branch(Node child) {
  explorer_.frontier_.branch(std::move(child));
}

template <class P>
void Expansion<P>::solution(Solution solution) {
  explorer_.report(std::move(solution));
}

template <class P>
double Expansion<P>::cutoff() const {
  return explorer_.incumbent_.objective;
}

template <class P>
Path Expansion<P>::path() const {
  return explorer_.frontier_.path();
}

}  // namespace kusabi::engine
