// error: a timed problem needs `double seconds() const` and `double least_seconds() const`
#include "tests/engine/misshapen/right.hpp"

using namespace misshapen;

struct Problem : Right<Problem> {
  double seconds() const { return 1; }
};

void look(const Problem& problem) {
  kusabi::engine::simulate(problem, 2, 1);
}
