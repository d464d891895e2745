// Certificates of both bounds of a critical friction coefficient: NAME.lower and NAME.upper.
#pragma once

#include <string>

#include "nodes/wedged/critical/bound_record.hpp"
#include "problems/wedged/wedged_problem.hpp"
#include "run/session/session.hpp"

namespace kusabi::run {

struct BoundCertificates {
  std::string name;    ///< without its ending; empty: none is written
  std::string input;   ///< problem file
  bool quiet = false;  ///< file names are not printed
};

/// True for the bounds whose certificates exist.
struct WrittenCertificates {
  bool lower = false;
  bool upper = false;
};

/// Recorder of both bounds. Session, problem and `written` must outlive it.
wedged::BoundRecorder bound_recorder(Session& session, BoundCertificates certificates,
                                     const problems::WedgedProblem& problem,
                                     WrittenCertificates& written);

}  // namespace kusabi::run
