// error: objective must be `double objective(const Solution& solution) const`
#include "tests/engine/misshapen/right.hpp"

using namespace misshapen;

struct Problem : Right<Problem> {
  const char* objective(const Solution& /*solution*/) const { return "cheap"; }
};

void look(Problem& problem) {
  kusabi::engine::search(problem);
}
