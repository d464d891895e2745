// error: bound must be `double bound(const Node& node) const`
#include "tests/engine/misshapen/right.hpp"

using namespace misshapen;

class Problem : public Right<Problem> {
 public:
  double objective(const Solution& /*solution*/) const { return 0; }

 private:
  double bound(const Node& /*node*/) const { return 0; }
};

void look(Problem& problem) {
  kusabi::engine::search(problem);
}
