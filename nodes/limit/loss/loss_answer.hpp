// Result on the loss of members as numbers, in the units of the problem (docs/theory/limit.md).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "engine/outcome.hpp"
#include "nodes/limit/root/limit_answer.hpp"
#include "verify/limit/truss_certificate.hpp"

namespace kusabi::limit {

/// Load factor that remains after the loss of one member, computed by the simplex method; with
/// uncertain loads that of the worst load found.
struct SingleLoss {
  int member = 0;
  LoadStatus status = LoadStatus::undetermined;
  double factor = 0;  ///< of `collapses`
};

/// Size of the search; it does not depend on the number of ranks unless the search was stopped.
struct LossCounts {
  std::uint64_t rounds = 0;
  std::uint64_t nodes = 0;
  std::uint64_t programs = 0;  ///< linear programs
  std::uint64_t states = 0;    ///< carrying stress states that were proved
};

struct LossAnswer {
  int maximum = 0;                  ///< K
  bool uncertain = false;           ///< over all admissible loads
  double sudden = 1;                ///< dynamic factor
  int eligible = 0;                 ///< number of members that may be lost
  double nominal = 0;               ///< load factor of the intact truss
  std::vector<SingleLoss> singles;  ///< by member; fewer if the run was stopped before
  /// The worst loss known, ascending; empty: no loss lowers the factor.
  std::vector<int> lost;
  /// Its collapse; nothing: no factor remains after it.
  std::optional<LimitCollapse> collapse;
  Eigen::VectorXd zeta;          ///< its worst load, m; empty: the dead load as given
  Eigen::VectorXd fatal_motion;  ///< shows that no factor remains after it; may be empty
  support::Bracket ends;         ///< open on both sides if the worst loss is fatal
  /// No load factor remains after the worst loss known; absent: one does.
  std::optional<support::Standing> fatal;
  /// Of `--at-least`: its factor, and true, false, or nothing: undecided.
  std::optional<double> target;
  std::optional<bool> reaches_target;
  support::Standing standing{};  ///< of the requested result
  std::uint64_t undecided = 0;   ///< nodes where a program or a proof failed
  LossCounts counts;
  engine::Status search = engine::Status::solved;  ///< reason of an early end
  /// The proved claims with their evidence, on rank 0; nothing: a bound is not proved.
  std::optional<verify::TrussTheorem> theorem;

  [[nodiscard]] bool proved() const { return is_proved(standing); }
};

}  // namespace kusabi::limit
