// Checks of uncertain loads, by parameters and components.
#include "problems/structure/checks/uncertainty_check.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "problems/structure/checks/structure_check.hpp"
#include "problems/structure/model/load_cases.hpp"

namespace kusabi::problems {
namespace {

class UncertaintyCheck {
 public:
  explicit UncertaintyCheck(const Structure& structure) : structure_(structure) {}

  void half_width(const UncertainParameter& parameter) const;
  void single(const UncertainParameter& parameter);
  void named(const UncertainParameter& parameter);

 private:
  void weight(double size, double given) const;
  bool is_fixed(const UncertainComponent& component) const {
    return structure_
        .fixed[static_cast<std::size_t>(component.node)][static_cast<std::size_t>(component.axis)];
  }
  std::string called(const UncertainComponent& component) const {
    const auto& node = structure_.node_names[static_cast<std::size_t>(component.node)];
    return fmt::format("component {} of the load at {}", axis_name(component.axis),
                       support::in_quotes(node));
  }
  [[noreturn]] void fail(std::string_view message) const {
    throw structure_error(structure_, position_of(structure_.sources.uncertain, index_), message);
  }

  const Structure& structure_;
  int index_ = 0;  // of the current component, over all parameters
  std::set<std::pair<int, int>> singles_;
  std::set<std::string> names_;
};

void UncertaintyCheck::weight(double size, double given) const {
  // The condition is false for NaN.
  if (!(size >= smallest_weight && size <= largest_weight)) {
    fail(fmt::format("the weight of an uncertain component is {:g}; expected between {:g} and {:g}",
                     given, smallest_weight, largest_weight));
  }
}

void UncertaintyCheck::half_width(const UncertainParameter& parameter) const {
  if (!parameter.half_width) return;
  // The condition is false for NaN.
  if (!(*parameter.half_width >= smallest_magnitude &&
        *parameter.half_width <= largest_magnitude)) {
    fail(fmt::format("the half-width of an uncertain load is {:g}; expected between {:g} and {:g}",
                     *parameter.half_width, smallest_magnitude, largest_magnitude));
  }
}

void UncertaintyCheck::single(const UncertainParameter& parameter) {
  if (parameter.components.size() != 1) {
    fail("an uncertain load without a name has no component or several; expected a name");
  }
  const auto& here = parameter.components.front();
  if (is_fixed(here)) {
    fail(fmt::format("{} is uncertain, but a support takes it; expected a free component",
                     called(here)));
  }
  if (!singles_.insert({here.node, here.axis}).second) {
    fail(fmt::format("{} is uncertain twice; expected once", called(here)));
  }
  weight(here.weight, here.weight);
  ++index_;
}

void UncertaintyCheck::named(const UncertainParameter& parameter) {
  const auto name = support::in_quotes(parameter.name);
  if (!names_.insert(parameter.name).second) {
    fail(fmt::format("two uncertain loads have the name {}; expected different names", name));
  }
  if (std::ranges::all_of(parameter.components, [&](const auto& each) { return is_fixed(each); })) {
    fail(
        fmt::format("the uncertain load {} is zero wherever the structure can move; expected a "
                    "force along an axis that is free",
                    name));
  }
  const auto size = [](const UncertainComponent& each) { return std::abs(each.weight); };
  const double largest = size(std::ranges::max(parameter.components, {}, size));
  std::set<std::pair<int, int>> seen;
  for (const auto& here : parameter.components) {
    if (!seen.insert({here.node, here.axis}).second) {
      fail(fmt::format("the uncertain load {} has {} twice; expected once", name, called(here)));
    }
    weight(size(here) < rounding_of_weights * largest ? largest : size(here), here.weight);
    ++index_;
  }
}

}  // namespace

void check_uncertainty(const Structure& structure) {
  if (!structure.uncertain) return;
  int index = 0;
  for (const auto& parameter : *structure.uncertain) {
    for (const auto& [node, axis, weight] : parameter.components) {
      if (node < 0 || node >= static_cast<int>(structure.node_names.size()) || axis < 0 ||
          axis >= structure.dimension) {
        throw structure_error(structure, position_of(structure.sources.uncertain, index),
                              fmt::format("uncertain component {} does not exist", index));
      }
      ++index;
    }
  }
  const auto cases = load_cases(structure);
  for (const auto& load_case : cases) check_uncertainty(in_load_case(structure, load_case));
  if (!cases.empty()) return;
  UncertaintyCheck check(structure);
  for (const auto& parameter : *structure.uncertain) {
    check.half_width(parameter);
    if (parameter.name.empty()) {
      check.single(parameter);
    } else {
      check.named(parameter);
    }
  }
}

}  // namespace kusabi::problems
