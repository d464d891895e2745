// error: a problem must be copyable to be simulated
#include "tests/engine/misshapen/right.hpp"

using namespace misshapen;

struct Problem : Right<Problem> {
  Problem() = default;
  Problem(const Problem&) = delete;
};

void look(const Problem& problem) {
  kusabi::engine::simulate(problem, 2, 1);
}
