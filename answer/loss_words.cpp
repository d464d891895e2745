// Sentences about the loss of members.
#include <algorithm>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "answer/answer_words.hpp"
#include "support/rounded_bounds.hpp"

namespace kusabi::answer {

std::string except_kept(const std::vector<std::string>& members) {
  constexpr std::size_t max_named = 8;
  if (members.empty()) return {};
  const auto shown = std::span(members).first(std::min(members.size(), max_named));
  return fmt::format(
      " except {}{} (kept)", fmt::join(shown, " "),
      members.size() <= max_named ? "" : fmt::format(" and {} more", members.size() - max_named));
}

std::string after_loss_of(const std::string& members, double sudden) {
  if (sudden == 1) return fmt::format("after the loss of {}", members);
  return fmt::format("after the sudden loss of {} with dynamic factor {}", members, sudden);
}

std::string after_worst_loss(const std::vector<std::string>& lost, double sudden) {
  if (!lost.empty()) return after_loss_of(fmt::format("{}", fmt::join(lost, " and ")), sudden);
  // The dynamic factor applies to losses only, and no loss raises the load factor.
  return sudden == 1 ? "without any loss" : after_loss_of("any member", sudden);
}

namespace {

// "after the loss of any 2 members"
std::string after_any(const MemberLoss& found) {
  const auto members =
      found.maximum == 1 ? "any one member" : fmt::format("any {} members", found.maximum);
  auto text = after_loss_of(members + except_kept(found.kept), found.sudden);
  if (found.uncertain) text += " and under every admissible load";
  if (found.cases > 1) text += fmt::format(", in each of {} load cases", found.cases);
  if (found.struts) text += ", while no strut falls below its residual strength";
  return text;
}

// The same at the beginning of a sentence.
std::string after_any_first(const MemberLoss& found) {
  return after_any(found) + (found.struts ? "," : "");
}

std::string at_most(const MemberLoss& found) {
  if (!found.factor.upper) return {};
  const auto& [value, standing] = *found.factor.upper;
  return fmt::format("{}{}{} {}{}", after_worst_loss(found.lost, found.sudden),
                     found.uncertain ? " and under the worst load" : "",
                     found.struts ? ", even with all struts at full strength," : "",
                     value < 0 ? "it carries its dead load only at load factors up to "
                               : "the limit load factor is at most ",
                     support::rounded_up(value)) +
         unless_proved(standing);
}

std::string of_target(const MemberLoss& found) {
  if (!found.reached) {
    return fmt::format("It is undecided whether the limit load factor is at least {} {}.",
                       *found.target, after_any(found));
  }
  if (*found.reached) {
    return capital(fmt::format("{} the limit load factor is at least {}.", after_any_first(found),
                               *found.target));
  }
  return capital(fmt::format("{}, less than {}.", at_most(found), *found.target));
}

}  // namespace

std::string headline_of(const MemberLoss& found, engine::Status /*ended*/) {
  if (found.fatal) {
    return capital(fmt::format("{} it does not carry {} dead load at any load factor{}.",
                               after_worst_loss(found.lost, found.sudden),
                               found.uncertain ? "some admissible" : "its",
                               unless_proved(*found.fatal)));
  }
  if (found.target) return of_target(found);
  if (const auto& lower = found.factor.lower) {
    const auto upper = at_most(found);
    return capital(fmt::format("{} the limit load factor is at least {}{}{}{}.",
                               after_any_first(found), support::rounded_down(lower->value),
                               unless_proved(lower->standing), upper.empty() ? "" : "; ", upper));
  }
  if (!found.factor.upper) return "The factor that remains after the loss of members is not known.";
  return capital(at_most(found)) + ".";
}

void reserve(const MemberLoss& found, engine::Status ended, std::vector<Reservation>& all) {
  if (found.fatal) {
    if (*found.fatal == Standing::computed)
      all.push_back({"Computed, not proved: no factor remains.", true});
    return;
  }
  if (found.target) {
    if (!found.reached)
      all.push_back({"No loss was found that leaves less, and none is excluded.", true});
    return;
  }
  if (!is_proved(found.factor.lower))
    all.push_back({"A lower bound of the factor that remains is not proved.", true});
  if (!is_proved(found.factor.upper) && ended == engine::Status::solved)
    all.push_back({"An upper bound of the factor that remains is not proved.", true});
}

}  // namespace kusabi::answer
