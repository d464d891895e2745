// Sentences of a verdict: the same on standard output, on standard error, in result files and in
// reports. A bound that is computed and not proved is marked as such wherever it is named.
#pragma once

#include <string>
#include <vector>

#include "answer/verdict.hpp"

namespace kusabi::answer {

/// The answer as a sentence: "It can stick in 27 ways at friction coefficient 0.65." Empty if the
/// command has no answer.
std::string headline(const Verdict& verdict);

/// A limitation of the headline.
struct Reservation {
  std::string sentence;
  bool open = false;  ///< the answer is not complete
};

/// Open parts, then results that are computed only.
std::vector<Reservation> reservations(const Verdict& verdict);

/// The claim of a certificate of load factors: "the worst-case load factor for alpha = 1 is between
/// …".
std::string factor_claim(const CertificateCheck::Factor& factor);

/// The claim of a certificate of the loss of members: "PROVED: after the loss of any member …".
std::string loss_claim(const CertificateCheck::Loss& loss);

/// A critical friction coefficient for a table: both bounds and their standing.
std::string bracket_line(const CriticalBracket& found);

}  // namespace kusabi::answer
