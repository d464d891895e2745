// A correct problem type, which the programs in this folder change into wrong ones.
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

// The parts common to all.
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
