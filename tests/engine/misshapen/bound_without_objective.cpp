// error: a problem with a bound needs `double objective(const Solution& solution) const`
#include "tests/engine/misshapen/right.hpp"

using namespace misshapen;

struct Problem : Right<Problem> {
  double bound(const Node& /*node*/) const { return 0; }
};

void look(Problem& problem) {
  kusabi::engine::search(problem);
}
