// error: a problem needs a type Node
#include "tests/engine/misshapen/right.hpp"

using namespace misshapen;

struct Problem {
  using Solution = Value;
};

void look(Problem& problem) {
  kusabi::engine::search(problem);
}
