// error: a problem needs a type Solution
#include "tests/engine/misshapen/right.hpp"

using namespace misshapen;

struct Problem {
  using Node = Value;
  Node root() const { return {}; }
};

void look(Problem& problem) {
  kusabi::engine::search(problem);
}
