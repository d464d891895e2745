// error: a problem needs `void expand(Node&& node, kusabi::engine::Expansion<P>& out)`
#include "tests/engine/misshapen/right.hpp"

using namespace misshapen;

struct Problem {
  using Node = Value;
  using Solution = Value;
  Node root() const { return {}; }
};

void look(Problem& problem) {
  kusabi::engine::search(problem);
}
