// error: a problem needs `Node root() const`
#include "tests/engine/misshapen/right.hpp"

using namespace misshapen;

struct Problem : Right<Problem> {
  Node root() { return {}; }
};

void look(Problem& problem) {
  kusabi::engine::search(problem);
}
