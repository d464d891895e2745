// The proof of both ends of a bracket of the critical friction coefficient: at each, the tree of
// sign patterns decides every node, and the evidence is put to the verifier's own test. An end
// that does not stand it is moved outwards until it does.
#pragma once

#include <functional>
#include <memory>
#include <span>

#include "engine/campaign.hpp"
#include "nodes/wedged/critical_findings.hpp"
#include "nodes/wedged/sign_pattern.hpp"
#include "problems/structure/structure.hpp"
#include "problems/wedged/wedged_problem.hpp"

namespace kusabi::wedged {

enum class CriticalEnd { lower, upper };

/// Takes down the evidence of one end while it is searched, on one rank.
class EndRecord {
 public:
  EndRecord() = default;
  EndRecord(const EndRecord&) = delete;
  EndRecord& operator=(const EndRecord&) = delete;
  virtual ~EndRecord() = default;

  virtual void add(const Evidence& evidence) = 0;

  /// When the search is done, on every rank alike. @param bounds that the evidence uses
  /// @param holds whether it shows what was wanted; else the end moves on, and there will be
  /// another record
  virtual void end(std::span<const ProvedBound> bounds, bool holds) = 0;
};

/// Begins a record, on every rank alike. @param factor the friction coefficient @param friction
/// that of each candidate @return null: this end is not to be taken down
using EndRecorder = std::function<std::unique_ptr<EndRecord>(CriticalEnd end, double factor,
                                                             std::span<const double> friction)>;

/// What the ends are moved by.
struct EndsQuestion {
  double width = 0;  ///< of the bracket asked for
  double most = 0;   ///< no end is above
  Tightening tightening = Tightening::automatic;
  bool with_patterns = true;  ///< whether those are asked for that live at the upper end
};

/// Proves the ends, or widens the bracket; finds the patterns that live at the upper end if they
/// are asked for. Says what stays open. On all ranks; the findings count on rank 0.
/// @pre the search was solved
void prove_ends(engine::Campaign& campaign, const problems::Structure& structure,
                const problems::WedgedProblem& problem, const EndsQuestion& question,
                const EndRecorder& recorder, CriticalFindings& findings);

}  // namespace kusabi::wedged
