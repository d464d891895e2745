// Checks at construction, degrees of freedom with them, bodies at the first request.
#include "problems/structure/checks/checked_structure.hpp"

#include <algorithm>
#include <iterator>
#include <mutex>
#include <utility>

#include <fmt/format.h>

#include "problems/structure/checks/structure_check.hpp"
#include "problems/structure/model/load_cases.hpp"

namespace kusabi::problems {

struct CheckedStructure::Derived {
  Structure structure;
  FreeDegrees degrees;
  std::once_flag bodies_derived;
  std::vector<UnconstrainedBody> bodies;
};

CheckedStructure::CheckedStructure(Structure structure) : derived_(std::make_shared<Derived>()) {
  check_structure(structure);
  derived_->degrees = free_degrees(structure);
  derived_->structure = std::move(structure);
}

const Structure& CheckedStructure::operator*() const {
  return derived_->structure;
}

const FreeDegrees& CheckedStructure::degrees() const {
  return derived_->degrees;
}

const std::vector<UnconstrainedBody>& CheckedStructure::unconstrained_bodies() const {
  std::call_once(derived_->bodies_derived, [this] {
    derived_->bodies = problems::unconstrained_bodies(derived_->structure);
  });
  return derived_->bodies;
}

void CheckedStructure::warn(std::vector<std::string> warnings) {
  std::ranges::move(warnings, std::back_inserter(derived_->structure.warnings));
}

CheckedStructure checked(Structure structure) {
  return CheckedStructure(std::move(structure));
}

CheckedStructure in_chosen_case(const CheckedStructure& structure, const std::string& name) {
  if (name.empty()) return structure;
  const auto names = load_cases(structure);
  if (std::ranges::find(names, name) == names.end()) {
    throw structure_error(
        structure, {},
        fmt::format("there is no load case {}; expected {}", support::in_quotes(name),
                    names.empty() ? "no --case" : "one of " + choice_of_load_cases(structure)));
  }
  return checked(in_load_case(structure, name));
}

}  // namespace kusabi::problems
