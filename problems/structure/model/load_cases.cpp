// Removal of the loads of other cases and of their places in the file.
#include "problems/structure/model/load_cases.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace kusabi::problems {
namespace {

// Keeps the entries of the case, each with its `sizes(entry)` places in the file.
template <class Entry, class Sizes>
void keep(std::vector<Entry>& entries, std::vector<support::SourcePosition>& positions,
          const std::string& load_case, Sizes sizes) {
  std::vector<Entry> kept;
  std::vector<support::SourcePosition> places;
  std::size_t place = 0;
  for (Entry& entry : entries) {
    const std::size_t size = sizes(entry);
    if (entry.load_case.empty() || entry.load_case == load_case) {
      for (std::size_t i = place; i < std::min(place + size, positions.size()); ++i)
        places.push_back(positions[i]);
      entry.load_case.clear();
      kept.push_back(std::move(entry));
    }
    place += size;
  }
  entries = std::move(kept);
  positions = std::move(places);
}

}  // namespace

std::vector<std::string> load_cases(const Structure& structure) {
  std::vector<std::string> names;
  const auto add = [&](const std::string& name) {
    if (!name.empty() && std::ranges::find(names, name) == names.end()) names.push_back(name);
  };
  for (const auto& load : structure.loads) add(load.load_case);
  if (!structure.uncertain) return names;
  for (const auto& parameter : *structure.uncertain) add(parameter.load_case);
  return names;
}

Structure in_load_case(Structure structure, const std::string& name) {
  keep(structure.loads, structure.sources.loads, name, [](const Load&) { return 1U; });
  if (structure.uncertain) {
    keep(*structure.uncertain, structure.sources.uncertain, name,
         [](const UncertainParameter& each) { return each.components.size(); });
  }
  std::erase_if(structure.actions, [&](const auto& each) { return each.load_case != name; });
  for (auto& each : structure.actions) each.load_case.clear();
  return structure;
}

std::string choice_of_load_cases(const Structure& structure) {
  std::vector<std::string> names;
  for (const auto& name : load_cases(structure)) names.push_back(support::in_quotes(name));
  return fmt::format("{}", fmt::join(names, ", "));
}

void check_certain(const Structure& structure) {
  if (!structure.uncertain) return;
  int index = 0;
  for (const auto& parameter : *structure.uncertain) {
    if (parameter.half_width) {
      throw structure_error(structure, position_of(structure.sources.uncertain, index),
                            "an uncertain load has a half-width, and states under load are those "
                            "of one load; expected loads without [lower, upper] and alpha, and no "
                            "[[actions]] with a range of factors");
    }
    index += static_cast<int>(parameter.components.size());
  }
}

}  // namespace kusabi::problems
