// Disjunctive cuts at the root: Algorithm 5.1 of the limit paper, for any mixed zero-one program.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "nodes/zero_one/relaxation.hpp"
#include "solvers/linear/basis.hpp"

namespace kusabi::zero_one {

/// Order of the binaries for cuts: the set J of Algorithm 5.1.
///
/// Where (51) finds no cut, the paper as printed would keep 0 >= 0 and repeat the same program
/// until the rounds are used up. Here such a binary is left out until the point changes.
class CutOrder {
 public:
  explicit CutOrder(std::size_t binaries) : without_cut_(binaries) {}

  /// Step 1: the binary with the largest residual tau (1 - tau) of those in J; nothing if none has
  /// any, or no cut is left to be found.
  std::optional<std::size_t> next(const std::vector<double>& residual);

  /// Step 4: after a cut that was kept all are in J, and after one that was not, all but its own.
  void kept() { new_point({}); }
  void rejected(std::size_t binary) { new_point(binary); }

  /// Records that (51) has no cut for it at this point.
  void found_none(std::size_t binary);

 private:
  void new_point(std::optional<std::size_t> rejected);
  [[nodiscard]] std::optional<std::size_t> largest(const std::vector<double>& residual) const;

  std::vector<bool> without_cut_;
  std::optional<std::size_t> rejected_;
};

/// Result of Algorithm 5.1.
struct CutRounds {
  std::uint64_t rounds = 0;    ///< values of k: at most 1.8 m
  std::uint64_t programs = 0;  ///< cut generating programs solved
  std::uint64_t found = 0;     ///< cuts that the optimum violated
  std::uint64_t kept = 0;      ///< of those, kept in step 4
  linear::Basis basis;         ///< an optimum of the relaxation with all kept cuts
};

/// Algorithm 5.1: adds cuts to the relaxation.
/// @param basis of an optimum of the relaxation
CutRounds add_disjunctive_cuts(Relaxation& relaxation, const linear::Basis& basis);

}  // namespace kusabi::zero_one
