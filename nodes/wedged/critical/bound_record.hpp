// Recorder of the evidence for the bounds of the critical friction coefficient.
#pragma once

#include <functional>
#include <memory>
#include <span>

#include "nodes/wedged/relaxation/candidate_bounds.hpp"
#include "nodes/wedged/tree/evidence.hpp"

namespace kusabi::wedged {

enum class BracketSide { lower, upper };

/// Claim of a record: all patterns, or one feasible pattern.
enum class BoundClaim { all_patterns, one_pattern };

/// Recorder of the evidence for one bound during its search, on one rank.
class BoundRecord {
 public:
  BoundRecord() = default;
  BoundRecord(const BoundRecord&) = delete;
  BoundRecord& operator=(const BoundRecord&) = delete;
  virtual ~BoundRecord() = default;

  virtual void add(const Evidence& evidence) = 0;

  /// Ends the record, on every rank alike. @param bounds used by the evidence
  /// @param holds true: the evidence proves the bound; false: the bound is relaxed and another
  /// record follows
  virtual void end(std::span<const ProvedBound> bounds, BoundClaim claim, bool holds) = 0;
};

/// Begins a record, on every rank alike.
/// @param factor the friction coefficient
/// @param friction that of each candidate
/// @return null: this bound is not recorded
using BoundRecorder = std::function<std::unique_ptr<BoundRecord>(BracketSide side, double factor,
                                                                 std::span<const double> friction)>;

}  // namespace kusabi::wedged
