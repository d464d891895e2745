// One sentence.
#include "run/wedged/ignored_loads.hpp"

#include <fmt/format.h>

#include "run/output/values.hpp"

namespace kusabi::run {

std::vector<std::string> ignored_loads(const problems::Structure& structure,
                                       std::string_view command) {
  const auto& sources = structure.sources;
  const auto uncertain = structure.uncertain ? structure.uncertain->size() : 0;
  if (structure.loads.empty() && uncertain == 0) return {};
  const auto position =
      problems::position_of(structure.loads.empty() ? sources.uncertain : sources.loads, 0);
  const auto message = fmt::format(
      "kusabi {} ignores {} of the file: a wedged configuration holds without loads; expected "
      "kusabi limit for limit loads of a truss, or a file without [[loads]]",
      command,
      structure.loads.empty() ? counted(uncertain, "uncertain load")
                              : counted(structure.loads.size(), "load"));
  return {problems::structure_error(structure, position, message).what()};
}

}  // namespace kusabi::run
