// Sentences of a verdict: the same on standard output, on standard error, in result files and in
// reports. A bound that is computed and not proved is marked as such wherever it is named.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "answer/verdict.hpp"

namespace kusabi::answer {

/// The answer as a sentence: "It can stick in 27 ways at friction coefficient 0.65." Empty if the
/// command has no answer.
std::string headline(const Verdict& verdict);

/// False also if it cannot.
bool is_known_to_stick(const Sticking& found);

/// What is true of all configurations of a pattern without a margin (t* = 0).
inline constexpr const char* of_flat_pattern =
    "some candidates are inactive, or some in contact slip";

/// What a list at one friction coefficient does not say. @param of_patterns also of each pattern
std::string next_step(bool of_patterns);

/// "proved" or "computed": for cells of tables, and in result files.
const char* standing_word(Standing standing);
/// Of the answer that no factor is held: "none, proved"; absent: "not known".
std::string none_standing_words(const std::optional<Standing>& none);

/// Standings of the lower and the upper bound of the sum of the normal reactions, for cells:
/// "proved"; "none, proved" without an upper bound; "no state, proved"; "not known".
std::array<std::string, 2> grip_standing_words(const HoldingGrip& grip);

/// The range of that sum as a line of a table, in which each bound has its standing.
std::string grip_line(const HoldingGrip& grip);

/// Suffix of a clause: empty if proved, otherwise " (computed, not proved)".
const char* unless_proved(Standing standing);

/// "(proved)" or "(computed, not proved)".
const char* in_brackets(Standing standing);

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

/// The claim with its proof: "PROVED: …".
std::string proved(const std::string& claim);

/// Sentences about certificates that a run was to write.
std::string no_certificate(const std::string& why);
/// Of a sweep. @param without at least one  @param all "3 coefficients"
std::string no_certificate_of(std::size_t without, const std::string& all, const std::string& why);
inline constexpr const char* no_proved_lower_bound =
    "No certificate of a lower bound was written, since none is proved.";
inline constexpr const char* no_grip_range =
    "The range of the sum of the normal reactions is not known.";
inline constexpr const char* no_proved_upper_bound =
    "No certificate of the upper bound was written, since it is computed, not proved.";
inline constexpr const char* nothing_is_proved = "it would contain no proof";
inline constexpr const char* stiffness_is_not_enclosed =
    "the stiffness matrix cannot be enclosed for its proofs: the structure is too large, or its "
    "numbers differ too much in size";
inline constexpr const char* not_all_is_proved = "not all bounds are proved";
inline constexpr const char* ended_before_the_proof =
    "the search stopped before both bounds were proved";

/// What is proved if exact arithmetic has found the same maximal cones as the search for rays, for a
/// table.
std::string cones_line(std::uint64_t cones);

/// A friction coefficient for a table: both bounds and their standing.
std::string bracket_line(const CriticalBracket& found);
std::string bracket_line(const HoldingBracket& found);

}  // namespace kusabi::answer
