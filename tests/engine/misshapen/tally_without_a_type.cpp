// error: tally must be `Tally tally() const`, and Tally a type of the problem
#include "tests/engine/misshapen/right.hpp"

using namespace misshapen;

struct Problem : Right<Problem> {
  int tally() const { return 0; }
};

void look(Problem& problem) {
  kusabi::engine::search(problem);
}
