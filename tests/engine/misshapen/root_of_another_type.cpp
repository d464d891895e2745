// error: a problem needs `Node root() const`
#include "tests/engine/misshapen/right.hpp"

using namespace misshapen;

struct Problem : Right<Problem> {
  int root() const { return 0; }
};

void look(Problem& problem) {
  kusabi::engine::search(problem);
}
