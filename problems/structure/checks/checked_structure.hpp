// CheckedStructure: a structure that obeys `check_structure`, with its degrees of freedom and
// unconstrained bodies, each derived once.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "problems/structure/bodies/rigid_motions.hpp"
#include "problems/structure/model/structure.hpp"
#include "problems/structure/model/truss.hpp"

namespace kusabi::problems {

/// A structure that cannot change any more. Copies share it and all that is derived from it.
class CheckedStructure {
 public:
  /// Nothing, to be assigned before any use.
  CheckedStructure() = default;

  /// @throws InputError if `check_structure` does
  explicit CheckedStructure(Structure structure);

  const Structure& operator*() const;
  const Structure* operator->() const { return &**this; }
  operator const Structure&() const { return **this; }

  /// Free displacements, constraints and nodes of several normals.
  [[nodiscard]] const FreeDegrees& degrees() const;

  /// Derived at the first call, since only wedged problems need them.
  /// @throws InputError as problems::unconstrained_bodies
  [[nodiscard]] const std::vector<UnconstrainedBody>& unconstrained_bodies() const;

  /// Appends to `Structure::warnings`, from which nothing is derived.
  void warn(std::vector<std::string> warnings);

 private:
  struct Derived;
  std::shared_ptr<Derived> derived_;
};

/// `CheckedStructure` of a structure made by a program.
CheckedStructure checked(Structure structure);

/// The structure with the loads of the case named by the user and the loads common to all cases.
/// @param name empty: the structure unchanged
/// @throws InputError if there is no such case
CheckedStructure in_chosen_case(const CheckedStructure& structure, const std::string& name);

}  // namespace kusabi::problems
