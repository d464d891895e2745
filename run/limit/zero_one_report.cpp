// Results of the zero-one program.
#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "answer/values.hpp"
#include "answer/words.hpp"
#include "run/limit/limit_report.hpp"
#include "support/rounded_bounds.hpp"

namespace kusabi::run {
namespace {

using limit::LimitWorstCase;
using limit::LimitZeroOne;

constexpr int digits_of_bounds = 10;

std::string m_text(const LimitZeroOne& zero_one) {
  return zero_one.big_m ? fmt::format("M = {}", *zero_one.big_m) : "M derived from static cuts";
}

std::string ends_text(const LimitZeroOne& zero_one) {
  const auto end = [](double value, const auto& rounded) {
    return std::isfinite(value) ? rounded(value, digits_of_bounds) : std::string("none");
  };
  return fmt::format("at least {}, at most {}", end(zero_one.lower, support::rounded_down),
                     end(zero_one.upper, support::rounded_up));
}

}  // namespace

std::string printed_ends_text(const LimitWorstCase& worst) {
  return fmt::format(
      "  load factor {}: bounds of the 0-1 program (29) with {}, valid if its M is large enough\n",
      ends_text(*worst.zero_one), m_text(*worst.zero_one));
}

std::string zero_one_text(const LimitWorstCase& worst) {
  const auto& zero_one = *worst.zero_one;
  std::string text;
  const auto out = std::back_inserter(text);
  const bool not_carried = worst.status == limit::RootStatus::not_carried;
  if (!worst.as_printed || not_carried) {
    fmt::format_to(out, "  the 0-1 program (29) alone, {}: {}{}\n", m_text(zero_one),
                   ends_text(zero_one), answer::unless_proved(support::Standing::computed));
  }
  if (is_refuted(worst)) {
    text += not_carried ? "  it is wrong: no M is large enough if a load is not carried\n"
                        : "  it is wrong: its M is too small\n";
  }
  if (zero_one.start) {
    fmt::format_to(out, "  it started from the worst of the random dead loads, {:.10g}\n",
                   *zero_one.start);
  }
  if (zero_one.cut_rounds > 0) {
    fmt::format_to(out,
                   "  Algorithm 5.1: {}, {}, {} kept; the relaxation (38) rose from {} to {}\n",
                   answer::counted(zero_one.cut_rounds, "round"),
                   answer::counted(zero_one.cut_programs, "program") + " (51)",
                   answer::counted(zero_one.cuts, "cut"),
                   support::rounded_down(zero_one.first_bound, digits_of_bounds),
                   support::rounded_down(zero_one.last_bound, digits_of_bounds));
  }
  fmt::format_to(out, "  Algorithm 4.2: {}, {}; {} before it\n",
                 answer::counted(zero_one.nodes, "node"),
                 answer::counted(zero_one.programs, "linear program"), zero_one.root_programs);
  return text;
}

nlohmann::ordered_json zero_one_json(const LimitZeroOne& zero_one) {
  return {{"big_m", answer::number_or_null(zero_one.big_m)},
          {"lower", answer::number_or_null(zero_one.lower)},
          {"upper", answer::number_or_null(zero_one.upper)},
          {"start", answer::number_or_null(zero_one.start)},
          {"first_bound", answer::number_or_null(zero_one.first_bound)},
          {"last_bound", answer::number_or_null(zero_one.last_bound)},
          {"cut_rounds", zero_one.cut_rounds},
          {"cut_programs", zero_one.cut_programs},
          {"cuts", zero_one.cuts},
          {"root_programs", zero_one.root_programs}};
}

bool is_refuted(const LimitWorstCase& worst) {
  if (!worst.zero_one) return false;
  if (worst.status == limit::RootStatus::not_carried) return worst.proved();
  double upper = worst.ends.at_most();
  if (!is_proved(worst.ends.upper)) {
    // The printed method: the load of its best point has a factor of its own.
    if (!worst.as_printed || !worst.collapse) return false;
    upper = worst.collapse->factor;
  }
  constexpr double visible = 1e-6;
  return worst.zero_one->lower > upper + visible * std::max(1.0, std::abs(upper));
}

}  // namespace kusabi::run
