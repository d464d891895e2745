// error: work_of_first_child must be a `static constexpr double` greater than 0
#include "tests/engine/misshapen/right.hpp"

using namespace misshapen;

struct Problem : Right<Problem> {
  double work_of_first_child = 0.5;
};

void look(Problem& problem) {
  kusabi::engine::search(problem);
}
