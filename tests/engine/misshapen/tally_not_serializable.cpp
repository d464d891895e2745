// error: a Tally needs `template <class Archive> void serialize(Archive& archive, unsigned
// version)`
#include "tests/engine/misshapen/right.hpp"

using namespace misshapen;

struct Problem : Right<Problem> {
  struct Tally {
    int count = 0;
  };
  Tally tally() const { return {}; }
};

void look(Problem& problem) {
  kusabi::engine::search(problem);
}
