// error: objective must be `double objective(const Solution& solution) const`
#include "tests/engine/misshapen/right.hpp"

using namespace misshapen;

struct Problem : Right<Problem> {
  double objective(const Solution& /*solution*/) { return 0; }
};

void look(Problem& problem) {
  kusabi::engine::search(problem);
}
