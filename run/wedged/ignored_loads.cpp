// A sentence on loads, and one on clearances.
#include "run/wedged/ignored_loads.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "run/output/values.hpp"

namespace kusabi::run {
namespace {

// Clearances are of states under load only.
void add_clearances(const problems::Structure& structure, std::string_view command,
                    std::vector<std::string>& lines) {
  const auto& contact = structure.contact;
  const auto apart = [](const auto& candidate) { return candidate.clearance != 0; };
  const auto first = std::ranges::find_if(contact, apart);
  if (first == contact.end()) return;
  const auto count = static_cast<std::uint64_t>(std::ranges::count_if(contact, apart));
  const auto message = fmt::format(
      "{} {} a clearance or an interference, which has no part in kusabi {}: there the gap is "
      "zero; "
      "expected kusabi hold for what friction can hold with it",
      counted(count, "contact candidate"), count == 1 ? "has" : "have", command);
  const auto position =
      problems::position_of(structure.sources.contact, static_cast<int>(first - contact.begin()));
  lines.emplace_back(problems::structure_error(structure, position, message).what());
}

}  // namespace

std::vector<std::string> ignored_loads(const problems::Structure& structure,
                                       std::string_view command) {
  std::vector<std::string> lines;
  const auto& sources = structure.sources;
  const auto uncertain = structure.uncertain ? structure.uncertain->size() : 0;
  if (!structure.loads.empty() || uncertain != 0) {
    const auto position =
        problems::position_of(structure.loads.empty() ? sources.uncertain : sources.loads, 0);
    const auto message = fmt::format(
        "{} of the file {} no part in kusabi {}: a wedged configuration holds without any load, "
        "and "
        "no load is needed for it; expected kusabi hold for the loads that friction can hold, "
        "kusabi "
        "limit for limit loads of a truss, or a file without [[loads]]",
        structure.loads.empty() ? counted(uncertain, "uncertain load")
                                : counted(structure.loads.size(), "load"),
        (structure.loads.empty() ? uncertain : structure.loads.size()) == 1 ? "has" : "have",
        command);
    lines.emplace_back(problems::structure_error(structure, position, message).what());
  }
  add_clearances(structure, command, lines);
  return lines;
}

}  // namespace kusabi::run
