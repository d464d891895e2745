// Worst case of uncertain loads from the root to its proof, on all ranks: static cuts or the 0-1
// program (29), the tree of signs below an open root, and both bounds in exact arithmetic. For the
// method as printed in the paper the bounds are proved only on request.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "nodes/limit/model/limit_parameters.hpp"
#include "nodes/limit/root/limit_answer.hpp"
#include "nodes/limit/root/root_search.hpp"
#include "nodes/limit/search/sign_tree.hpp"
#include "nodes/limit/search/zero_one_worst.hpp"
#include "verify/limit/truss_certificate.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::limit {

/// Result of a tree of signs below a root.
struct SignSearch {
  engine::Status status = engine::Status::solved;  ///< on every rank
  std::uint64_t nodes = 1;                         ///< on rank 0, as are the following
  std::uint64_t programs = 0;                      ///< linear programs
  std::uint64_t corners = 0;                       ///< nodes with one load
  std::vector<ClosedNode> closed;                  ///< with their proofs
};

/// Searches the tree of signs below an open root.
/// @param alpha scaled
/// @param root receives loads with smaller factors, on every rank
/// @param proof of a load without factor
SignSearch search_signs(RootSearch& search, RootResult& root, double alpha, NoFactorProof proof);

/// One worst case. Every rank makes the same calls.
class WorstCaseSearch {
 public:
  /// @pre all but `start` outlive this object.
  /// @param truss for the proofs
  /// @param start initial point of (29)
  /// @pre parameters.alpha
  WorstCaseSearch(RootSearch& search, const LimitParameters& parameters,
                  const verify::Structure& truss, std::optional<ZeroOneStart> start = {})
      : search_(search), parameters_(parameters), truss_(truss), start_(std::move(start)) {}

  /// By the requested method. @throws BigMTooSmall on every rank
  LimitWorstCase solve();

  /// The evidence of both bounds of the last one, if both are proved, on rank 0; or that some load
  /// has no factor.
  [[nodiscard]] std::optional<verify::TrussTheorem>& theorem() { return theorem_; }

 private:
  LimitWorstCase by_static_cuts();
  LimitWorstCase by_zero_one_program();
  LimitWorstCase as_printed();
  void take_if_worse(const Eigen::VectorXd& motion, Worst& known);
  void show_critical_load(const Eigen::VectorXd& motion, LimitWorstCase& worst);
  void conclude(RootResult& root, LimitWorstCase& worst);
  void prove(const RootResult& root, std::vector<ClosedNode> nodes, LimitWorstCase& worst);
  void bound_in_little_time(RootResult& root);
  bool prove_no_factor(const Eigen::VectorXd& zeta, const Eigen::VectorXd& motion,
                       LimitWorstCase& worst);
  [[nodiscard]] const problems::LimitModel& model() const { return search_.model(); }
  [[nodiscard]] double alpha() const { return *parameters_.alpha; }

  RootSearch& search_;
  const LimitParameters& parameters_;
  const verify::Structure& truss_;
  std::optional<ZeroOneStart> start_;
  std::optional<verify::TrussTheorem> theorem_;
};

}  // namespace kusabi::limit
