// Load cases of combinations of actions by EN 1990, 6.4.3.2, from the actions as plain data.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "problems/files/sections/loads_file.hpp"
#include "problems/files/toml/toml_reader.hpp"
#include "problems/structure/model/structure.hpp"

namespace kusabi::problems {

/// Range of the factor of an action in one combination.
struct FactorRange {
  double lower;
  double upper;
};

struct Action {
  TomlText name;
  std::optional<FactorRange> permanent{};  ///< gamma_inf, gamma_sup; absent: a variable action
  double factor = 0;                       ///< gamma_Q
  double combination = 0;                  ///< psi_0; 0 where another action leads
  bool either_way = false;
  std::string alternatives{};                ///< actions with the same text exclude each other
  std::vector<ForceComponent> components{};  ///< each once
};

/// Actions and the rule that combines them.
struct ActionCombinations {
  std::vector<Action> actions{};
  std::size_t reference = 0;  ///< of the actions: the variable one that the load factor multiplies
  bool both_rules = false;    ///< (6.10a) and (6.10b) in place of (6.10)
  double reduction = 1;       ///< xi of (6.10b)

  /// Number of variable actions that can act together: those that exclude each other count once.
  [[nodiscard]] std::size_t variable_sets() const;

  /// Number of load cases; a double, since exclusive actions multiply it.
  [[nodiscard]] double cases() const;

  /// Adds the load cases to a structure without loads: dead loads and uncertain loads of fixed
  /// half-width, the reference load, and the factors of the actions.
  void add_to(Structure& structure) const;
};

}  // namespace kusabi::problems
