// A problem with nothing wrong, for the programs beside to spoil.
#pragma once

#include "engine/search.hpp"
#include "engine/simulation.hpp"

namespace misshapen {

struct Value {
  int number = 0;

  template <class Archive>
  void serialize(Archive& archive, unsigned /*version*/) {
    archive& number;
  }
};

// Without what the derived class brings.
template <class Derived, class NodeType = Value, class SolutionType = Value>
struct Right {
  using Node = NodeType;
  using Solution = SolutionType;

  Node root() const { return {}; }
  void expand(Node&& /*node*/, kusabi::engine::Expansion<Derived>& out) {
    out.branch({});
    out.solution({});
  }
};

}  // namespace misshapen
