// True if there is one component of weight one per load.
#include "run/results/alpha_unit.hpp"

#include <cmath>

namespace kusabi::run {

std::optional<std::string> unit_of_alpha(const ResultReader& reader) {
  const auto& problem = reader.at(reader.all(), "problem");
  const auto* const loads = ResultReader::find(problem, "uncertain_loads");
  for (const auto& load : loads != nullptr ? *loads : ResultJson::array()) {
    const auto& components = reader.list(load, "components");
    if (components.size() != 1 || std::abs(reader.number(components[0], "weight")) != 1)
      return std::nullopt;
  }
  return reader.text(reader.at(problem, "units"), "force");
}

}  // namespace kusabi::run
