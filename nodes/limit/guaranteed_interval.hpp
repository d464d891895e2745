// Load factors that are carried under every admissible load: an interval from the maximum of the
// least factors to the minimum of the largest ones (docs/theory/limit.md). It may be empty.
#pragma once

#include <optional>
#include <span>

#include "nodes/limit/root/limit_answer.hpp"

namespace kusabi::limit {

struct GuaranteedInterval {
  support::Bracket minimum;  ///< of the smallest guaranteed factor L
  support::Bracket largest;  ///< of the largest guaranteed factor H
  /// Some admissible load has no factor; absent: none is known to have none.
  std::optional<support::Standing> at_none;

  /// True if the bounds prove that no factor is carried under all admissible loads.
  [[nodiscard]] bool is_empty() const { return at_none || minimum.at_least() > largest.at_most(); }
  /// True if the bounds prove that some factor is.
  [[nodiscard]] bool has_factors() const {
    return !at_none && minimum.upper && minimum.at_most() <= largest.at_least();
  }
  /// proved: one of the two is proved.
  [[nodiscard]] support::Standing standing() const;
  /// True if every factor from 0 to 1, the stages of loading up to the design load, is proved to be
  /// carried under all admissible loads; false if one is proved not to be; otherwise nothing.
  [[nodiscard]] std::optional<bool> passed() const;
};

/// Standing of the claim that some admissible load, or the nominal one without a worst case, has no
/// factor; nothing: none is known to have none.
std::optional<support::Standing> at_no_factor(const LimitAnswer& answer);

/// That of the worst case. Where its search ended without a bound, the nominal load bounds it from
/// outside.
GuaranteedInterval guaranteed_interval(const LimitAnswer& answer);

/// The same for a truss with struts: the factors at residual strength are carried, and those beyond
/// the interval at full strength are not. @param residual the answer at residual strength; nothing:
/// no member is a strut
GuaranteedInterval guaranteed_interval(const LimitAnswer& answer,
                                       const std::optional<LimitAnswer>& residual);

/// The factors that are carried under the nominal dead load. @param residual as above
GuaranteedInterval nominal_interval(const LimitAnswer& answer,
                                    const std::optional<LimitAnswer>& residual);

/// The factors that are carried in all load cases. @param cases at least one
GuaranteedInterval intersection(std::span<const GuaranteedInterval> cases);

}  // namespace kusabi::limit
