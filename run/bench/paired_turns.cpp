#include "run/bench/paired_turns.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace kusabi::run {

void PairedTurns::add_search(const Turn& turn) {
  search_ += turn;
  search_seconds_ += turn.seconds;
  if (recursion_.seconds < least_ || search_.seconds < least_) return;
  ratios_.push_back(open_ratio());
  recursion_ = search_ = {};
}

std::vector<double> PairedTurns::ratios() const {
  const bool whole = ratios_.empty() && recursion_.nodes > 0 && search_.seconds > 0;
  return whole ? std::vector{open_ratio()} : ratios_;
}

double PairedTurns::open_ratio() const {
  return recursion_.seconds * static_cast<double>(search_.nodes) /
         (static_cast<double>(recursion_.nodes) * search_.seconds);
}

Quartiles quartiles(std::vector<double> values) {
  std::ranges::sort(values);
  const auto at = [&](double share) {
    const double place = share * static_cast<double>(values.size() - 1);
    const auto below = static_cast<std::size_t>(place);
    const auto above = std::min(below + 1, values.size() - 1);
    return std::lerp(values[below], values[above], place - static_cast<double>(below));
  };
  return {at(0.25), at(0.5), at(0.75)};
}

}  // namespace kusabi::run
