// Certificates of the loss of members: the truss in coordinates and, for each load case, carrying
// stress states for the lower bound, the worst loss and a motion for the upper bound.
// docs/certificates.md describes the file; verify/limit/loss_claim.hpp proves the claims.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "verify/limit/stress_state.hpp"
#include "verify/structure/structure.hpp"

namespace kusabi::verify {

/// The first line.
inline constexpr std::string_view loss_first_line = "kusabi certificate 5 loss";

/// A claim and its evidence. All numbers are finite and all indices within range.
struct LossStatement {
  std::string load_case;  ///< empty: the problem file has no load cases
  /// Places, supports, bars and loads; without uncertain loads, the dead load as given is meant.
  Structure truss;
  double sudden = 1;              ///< the yield forces are those of the file, divided by this
  std::size_t maximum = 1;        ///< K, >= 1
  std::vector<std::size_t> kept;  ///< members that are not lost, ascending
  std::vector<std::size_t> lost;  ///< the worst loss, ascending
  std::vector<double> load;       ///< zeta, one for each uncertain load
  std::vector<double> motion;     ///< u after that loss, by displacement
  bool fatal = false;             ///< no factor remains after it, with a motion that shows it
  bool residual = false;          ///< the compression strengths are those of buckled struts
  std::optional<double> lower;    ///< claimed lower bound; nothing: none
  std::vector<StressState> states;
};

/// The text of a file. @param statements of one truss, at least one; one at residual strength
///        follows that of its load case at strength
std::string loss_certificate_text(std::span<const LossStatement> statements);

/// The statements of a file. @param file for messages
/// @throws CertificateError
std::vector<LossStatement> read_loss_certificate(std::string_view text, const std::string& file);

}  // namespace kusabi::verify
