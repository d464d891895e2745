// Zero-one tree: Algorithm 4.2 of the limit paper, for any mixed zero-one linear program.
//
// A node is a pair (J0, J1) of sets of binaries, fixed at 0 and at 1. Its bound is the linear
// relaxation with those fixings, solved by the dual simplex method from its parent's basis, which
// is stored in the node: its result depends on the node alone, and the tree is the same on any
// number of ranks. It is closed if it is infeasible, if its bound excludes anything better than the
// incumbent, or if all binaries of its optimum are 0 or 1.
//
// Objectives are distinguished in steps (objective_steps.hpp): otherwise the search would enumerate
// many optima that are equal up to rounding.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <tuple>
#include <vector>

#include <boost/serialization/vector.hpp>

#include "engine/counts.hpp"
#include "engine/expansion.hpp"
#include "engine/search_declaration.hpp"
#include "nodes/zero_one/fixings.hpp"
#include "nodes/zero_one/incumbent_search.hpp"
#include "nodes/zero_one/objective_steps.hpp"
#include "nodes/zero_one/relaxation.hpp"
#include "nodes/zero_one/root.hpp"
#include "solvers/linear/basis.hpp"

namespace kusabi::zero_one {

struct ZeroOneNode {
  Fixings fixings;
  linear::Basis basis;  ///< of the parent's optimum, or a nearer one
  double bound = -std::numeric_limits<double>::infinity();

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& fixings& basis& bound;
  }
};

/// Counts of opened nodes by their result, and costs.
struct ZeroOneTally : engine::Counts<ZeroOneTally> {
  std::uint64_t branched = 0;
  std::uint64_t infeasible = 0;  ///< closed: infeasible
  std::uint64_t above = 0;       ///< closed: nothing better can be below
  std::uint64_t leaves = 0;      ///< closed: the optimum has all binaries at 0 or 1
  std::uint64_t points = 0;      ///< found by rounding
  /// Closed by the result of the simplex method without a proof: infeasible, or (a leaf) not
  /// solved. Their bounds are in `least_bound`.
  std::uint64_t unproved = 0;
  std::uint64_t held = 0;        ///< binaries fixed by reduced costs or by look-ahead
  std::uint64_t programs = 0;    ///< linear programs
  std::uint64_t iterations = 0;  ///< of the simplex method
  /// The least bound of the nodes closed here: a lower bound of all points that were not pruned
  /// unopened.
  engine::Least least_bound;

  static constexpr auto fields() {
    return std::tuple{field("branched", &ZeroOneTally::branched),
                      field("infeasible", &ZeroOneTally::infeasible),
                      field("above", &ZeroOneTally::above),
                      field("leaves", &ZeroOneTally::leaves),
                      field("points", &ZeroOneTally::points),
                      field("unproved", &ZeroOneTally::unproved),
                      field("held", &ZeroOneTally::held),
                      field("programs", &ZeroOneTally::programs),
                      field("iterations", &ZeroOneTally::iterations),
                      field("least_bound", &ZeroOneTally::least_bound)};
  }
};

/// Branching rule. All rules give the same optimum.
enum class ZeroOneBranching {
  /// The largest tau (1 - tau), 1 first: Algorithm 4.2. The fastest on random programs.
  paper,
  /// Of some with large tau (1 - tau) the one whose children's bounds rise most, by some steps of
  /// the dual simplex method; the lower child first. Fewer nodes, more linear programs.
  look_ahead,
};

/// Problem type of engine::search, with Goal::best.
class ZeroOneTree {
 public:
  using Node = ZeroOneNode;
  using Solution = ZeroOnePoint;
  using Tally = ZeroOneTally;

  explicit ZeroOneTree(ZeroOneRoot root, ZeroOneBranching branching = ZeroOneBranching::paper);

  Node root() const;
  void expand(Node&& node, engine::Expansion<ZeroOneTree>& out);
  /// In whole steps.
  double objective(const Solution& point) const { return in_steps(point.objective); }
  double bound(const Node& node) const { return in_steps(node.bound); }
  Tally tally() const;

  /// Lower bound of the optimum from the outcome of a search: engine::Outcome::bound (in steps, of
  /// open and pruned nodes) and the sum of all tallies. It is proved if the relaxation proves its
  /// bounds.
  [[nodiscard]] double lower_bound(double outcome_bound, const Tally& total) const;

  /// True if bounds hold despite rounding.
  [[nodiscard]] bool proves() const { return root_.relaxation.proves() && root_.counts.proved; }

  [[nodiscard]] const ZeroOneRoot& prepared() const { return root_; }

 private:
  struct Split;

  using Out = engine::Expansion<ZeroOneTree>;

  [[nodiscard]] double raised(double bound) const;
  [[nodiscard]] bool worse_than_root_point(double bound) const;
  [[nodiscard]] std::vector<std::size_t> free_binaries(const Node& node) const;

  bool settle(Node& node, Out& out);
  bool close_if_whole(const Node& node, Out& out);
  void close(const Node& node, std::uint64_t& how);
  void close_without_proof(const Node& node);
  void fix_by_reduced_cost(Node& node);
  void try_rounding(const Node& node, Out& out);
  std::optional<Split> look_ahead(Node& node, const std::vector<std::size_t>& candidates,
                                  double before);
  void branch(const Node& node, const Split& split, bool one_first, Out& out);

  ZeroOneRoot root_;
  ZeroOneBranching branching_;
  Tally tally_;
  std::uint64_t programs_before_;
  std::uint64_t iterations_before_;
};

}  // namespace kusabi::zero_one

extern template kusabi::engine::OutcomeOf<kusabi::zero_one::ZeroOneTree> kusabi::engine::search(
    kusabi::zero_one::ZeroOneTree&, kusabi::engine::Transport&, const kusabi::engine::Options&);
