// error: bound must be `double bound(const Node& node) const`
#include "tests/engine/misshapen/right.hpp"

using namespace misshapen;

struct Other {};
struct Problem : Right<Problem> {
  double objective(const Solution& /*solution*/) const { return 0; }
  double bound(const Other& /*node*/) const { return 0; }
};

void look(Problem& problem) {
  kusabi::engine::search(problem);
}
