// Certificates of `kusabi hold`: NAME.lower and NAME.upper of a holding friction coefficient, NAME
// of load factors at one coefficient (docs/certificates.md).
#pragma once

#include <optional>
#include <string>

#include "nodes/wedged/hold/hold_record.hpp"
#include "run/session/session.hpp"

namespace kusabi::run {

struct HoldCertificates {
  std::string name;               ///< empty: none is written
  std::string input;              ///< problem file
  std::string load_case;          ///< empty: all loads of the file act
  std::optional<double> total{};  ///< sum of the normal reactions in all states
  bool quiet = false;             ///< file names are not printed
};

/// Empty if there is no name. Session and problem must outlive it.
wedged::HoldRecorder hold_recorder(Session& session, HoldCertificates certificates,
                                   const wedged::LoadedProblem& loaded);

}  // namespace kusabi::run
