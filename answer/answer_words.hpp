// Sentences for each kind of answer.
#pragma once

#include <string>
#include <vector>

#include "answer/words.hpp"

namespace kusabi::answer {

// Headlines. @param ended of the search

std::string headline_of(const Sticking& found, engine::Status ended);
std::string headline_of(const CriticalBracket& found, engine::Status ended);
std::string headline_of(const HoldingBracket& found, engine::Status ended);
std::string headline_of(const HoldingFactors& found, engine::Status ended);
std::string headline_of(const HoldingSweep& found, engine::Status ended);
std::string headline_of(const HoldingDiagram& found, engine::Status ended);
std::string headline_of(const FrictionSteps& found, engine::Status ended);
std::string headline_of(const LoadInterval& found, engine::Status ended);
std::string headline_of(const MemberLoss& found, engine::Status ended);
std::string headline_of(const LoadSteps& found, engine::Status ended);
std::string headline_of(const MixedOptimum& found, engine::Status ended);
std::string headline_of(const CertificateCheck& found, engine::Status ended);

// Reservations besides an early end, added to `all`.

void reserve(const Sticking& found, engine::Status ended, std::vector<Reservation>& all);
void reserve(const CriticalBracket& found, engine::Status ended, std::vector<Reservation>& all);
void reserve(const HoldingBracket& found, engine::Status ended, std::vector<Reservation>& all);
void reserve(const HoldingFactors& found, engine::Status ended, std::vector<Reservation>& all);
void reserve(const HoldingSweep& found, engine::Status ended, std::vector<Reservation>& all);
void reserve(const HoldingDiagram& found, engine::Status ended, std::vector<Reservation>& all);
void reserve(const FrictionSteps& found, engine::Status ended, std::vector<Reservation>& all);
void reserve(const LoadInterval& found, engine::Status ended, std::vector<Reservation>& all);
void reserve(const MemberLoss& found, engine::Status ended, std::vector<Reservation>& all);
void reserve(const LoadSteps& found, engine::Status ended, std::vector<Reservation>& all);
void reserve(const MixedOptimum& found, engine::Status ended, std::vector<Reservation>& all);
void reserve(const CertificateCheck& found, engine::Status ended, std::vector<Reservation>& all);

/// "It cannot stick below friction coefficient 0.3; at 0.31 it can." @pre a bound is known
/// @param ability "stick" @param maximum of the search @param wide wider than requested, or not
/// complete
std::string friction_sentence(const std::string& ability, const Bracket& bracket, bool factor,
                              double maximum, bool wide);

/// Adds the coefficients up to the maximum at which it is undecided whether it has the ability.
void reserve_undecided(const std::string& ability, const Bracket& bracket, double maximum,
                       std::vector<Reservation>& all);

/// The range of sums of normal reactions.
std::string grip_sentence(const HoldingGrip& grip);

/// " except a-b c-d (kept)": members that are not lost; empty if there are none.
std::string except_kept(const std::vector<std::string>& members);

/// "after the loss of any one member", "after the sudden loss of any 2 members with dynamic factor
/// 2". @param members that are lost @param sudden dynamic factor, 1 for a loss that is not sudden
std::string after_loss_of(const std::string& members, double sudden);

/// The same of the worst loss; of any loss if `lost` is empty and a loss is sudden, since no loss
/// raises the factor; otherwise "without any loss".
std::string after_worst_loss(const std::vector<std::string>& lost, double sudden);

/// The text with a capital at its beginning. @pre it is not empty
std::string capital(std::string text);

/// "± 0.45 kN": half-width of an uncertain load.
std::string half_width_text(double half_width, const std::optional<std::string>& force);

}  // namespace kusabi::answer
