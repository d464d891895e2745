// Proof of a theorem on a truss in exact arithmetic. The collapse bounds the factor from above;
// nodes, or states after losses, bound it from below: each is proved by itself, and they cover all
// loads and losses.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "verify/limit/exact_truss.hpp"
#include "verify/limit/limit_proof.hpp"
#include "verify/limit/limit_truss.hpp"
#include "verify/limit/truss_certificate.hpp"

namespace kusabi::verify {

class TrussProof {
 public:
  /// @pre the theorem outlives this object; its truss is a plain one, with uncertain loads
  explicit TrussProof(const TrussTheorem& theorem);
  TrussProof(const TrussProof&) = delete;
  TrussProof& operator=(const TrussProof&) = delete;
  ~TrussProof() = default;

  /// Everything except the pieces. @return refusals
  /// @param upper receives the upper bound of the factor, minus infinity if there is no factor
  [[nodiscard]] std::vector<std::string> refusals(double& upper) const;

  /// The nodes and states, whose least lower bound is that of the factor.
  [[nodiscard]] std::size_t pieces() const {
    return theorem_.nodes.size() + theorem_.states.size();
  }

  /// The lower bound of a piece, rounded down, or the reason why it is not proved.
  [[nodiscard]] std::variant<double, std::string> lower(std::size_t piece) const;

 private:
  const TrussTheorem& theorem_;
  std::optional<LimitTruss> truss_;  // nothing: a direction is undefined
  std::optional<LimitProof> proof_;
  ExactTruss exact_;  // of losses
};

}  // namespace kusabi::verify
