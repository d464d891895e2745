// Tree for worst-case loads that static cuts at the root do not decide: branching on the sign of
// t_j'u, which is the 0-1 variable tau_j of the limit paper's (29) without its big M.
//
// A node has some signs decided. Its bound is the relaxation of nodes/limit/root/master.hpp with
// the cuts of the root and some of its own. With all signs decided it is a corner, whose bound is
// the factor of its load, so the tree is finite. Nodes with few undecided signs are divided into
// their corners without a bound. Each closed node stores the static proof of its bound.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <boost/serialization/vector.hpp>

#include "engine/expansion.hpp"
#include "engine/search_declaration.hpp"
#include "nodes/limit/root/corner.hpp"
#include "nodes/limit/root/worst_case.hpp"

namespace kusabi::limit {

/// A closed node with the proof of its bound.
struct ClosedNode {
  Signs signs;
  double factor = 0;
  std::vector<double> forces;     ///< empty: without a proof
  std::vector<double> mu;         ///< of the cuts of the root, then of `own_cuts`
  std::vector<double> one_sided;  ///< nu
  std::vector<StaticCut> own_cuts;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& signs& factor& forces& mu& one_sided& own_cuts;
  }
};

ClosedNode closed_node(const StaticProof& proof, std::vector<StaticCut> own_cuts);

/// True if the motion proves that a load has no factor. @param zeta m, scaled @param motion n^d, scaled
using NoFactorProof =
    std::function<bool(const Eigen::VectorXd& zeta, const Eigen::VectorXd& motion)>;

/// Problem type of engine::search, for Goal::best. It passes no bounds of nodes to the engine: each
/// is opened, so that each has a proof.
class SignTree {
 public:
  struct Node {
    Signs signs;

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& signs;
    }
  };

  /// A load with a smaller factor than the initial one.
  struct Solution {
    double factor = 0;  ///< minus infinity: the load has no factor, and
    std::vector<double> zeta;
    std::vector<double> motion;  ///< this motion shows it
    std::vector<double> forces;

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& factor& zeta& motion& forces;
    }
  };

  struct Tally {
    std::uint64_t branched = 0;
    std::uint64_t closed = 0;
    std::uint64_t corners = 0;   ///< closed with one load
    std::uint64_t unsolved = 0;  ///< those of them where the simplex method failed
    WorstCaseCounts counts;
    std::vector<ClosedNode> evidence;

    template <class Archive>
    void serialize(Archive& archive, unsigned /*version*/) {
      archive& branched& closed& corners& unsolved& counts.load_factors& counts.relaxations& counts
          .pricings;
      archive& counts.rounds& evidence;
    }
  };

  /// @param root with status `open`. All arguments must outlive the tree
  /// @param keep_evidence whether closed nodes are added to the tally
  /// @param stop ends the opening of a node, which stays open
  /// @param proof of a load without factor, which ends the search; empty: none is required
  SignTree(const problems::LimitModel& model, double alpha, const RootResult& root,
           bool keep_evidence, support::Stop stop = {}, NoFactorProof proof = {});

  Node root() const;
  void expand(Node&& node, engine::Expansion<SignTree>& out);
  double objective(const Solution& solution) const { return solution.factor; }
  Tally tally() const;

 private:
  // The relaxation at a node after rounds of cuts of its own.
  struct Bounded {
    double bound = 0;
    Relaxed point;
  };
  std::optional<Bounded> bounded(const Node& node);
  void branch_on(std::size_t column, bool positive_first, const Node& node,
                 engine::Expansion<SignTree>& out);
  void divide(const Node& node, engine::Expansion<SignTree>& out);
  std::optional<StaticProof> corner_proof(const Signs& signs);
  void open_corner(Node&& node, engine::Expansion<SignTree>& out);
  void open_relaxed(Node&& node, engine::Expansion<SignTree>& out);
  double descend_from(const Bounded& node, engine::Expansion<SignTree>& out);
  bool report_no_factor(const Eigen::VectorXd& zeta, const Eigen::VectorXd& motion,
                        engine::Expansion<SignTree>& out);
  void report(const Worst& worst, engine::Expansion<SignTree>& out);
  void close(const Signs& signs);

  const problems::LimitModel& model_;
  double alpha_;
  const RootResult& root_;
  bool keep_evidence_;
  support::Stop stop_;
  NoFactorProof proof_;
  LoadFactor load_factor_;
  splitting::SafeStates states_;  // of corners
  StaticPricing pricing_;
  Master master_;
  std::vector<StaticCut> own_cuts_;  // of the current node
  Tally tally_;
};

}  // namespace kusabi::limit

extern template kusabi::engine::OutcomeOf<kusabi::limit::SignTree> kusabi::engine::search(
    kusabi::limit::SignTree&, kusabi::engine::Transport&, const kusabi::engine::Options&);
