// The certificates of both ends of a critical friction coefficient: NAME.lower and NAME.upper.
#pragma once

#include <string>

#include "nodes/wedged/critical_ends.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/session/session.hpp"

namespace kusabi::run {

struct EndCertificates {
  std::string name;    ///< without its ending; empty: nothing is recorded
  std::string input;   ///< the problem file
  bool quiet = false;  ///< whether not to say which files were written
};

/// Session and problem must outlive what is returned.
wedged::EndRecorder end_recorder(Session& session, EndCertificates certificates,
                                 const problems::WedgedProblem& problem);

}  // namespace kusabi::run
