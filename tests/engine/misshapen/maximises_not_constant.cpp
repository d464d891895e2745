// error: maximises must be `static constexpr bool maximises = true`
#include "tests/engine/misshapen/right.hpp"

using namespace misshapen;

struct Problem : Right<Problem> {
  bool maximises = true;
  double objective(const Solution& /*solution*/) const { return 0; }
};

void look(Problem& problem) {
  kusabi::engine::search(problem);
}
